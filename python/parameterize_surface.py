#!/usr/bin/env python3
"""Maps the inside of a closed surface, and writes tetrahedra and hexahedra for ParaView, with the help of meshio.

usage: parameterize_surface.py SURFACE [TETRAHEDRA.vtu [HEXAHEDRA.vtu]]
"""

import sys

import meshio
import volume_mesh_parameterization as vmp


def main(surface_file, tetrahedra_file="tetrahedra.vtu", hexahedra_file="hexahedra.vtu"):
    # 1. Read a surface of triangles.
    try:
        surface = meshio.read(surface_file)
    except (OSError, UnicodeDecodeError, meshio.ReadError) as error:
        return f"{surface_file}: {error}"
    triangles = surface.get_cells_type("triangle")

    # 2. Fill it, find floor, ceiling and walls, and map it.
    try:
        solid = vmp.parameterize_surface(surface.points, triangles, number_of_cells=20000)
    except vmp.Error as error:
        return f"{surface_file}: {error} (code {error.code})"
    print(f"a solid with {solid.genus} hole(s)")

    # 3. Take the map that is linear on each tetrahedron if there is one, else that along curves.
    mesh = solid.piecewise_linear()
    if mesh is None:
        print(f"no piecewise linear map: {solid.why_not_piecewise_linear()}")
        mesh = solid.mesh()

    # 4. Write the tetrahedra. With PyVista, pyvista.UnstructuredGrid({10: mesh["cells"]}, mesh["points"]) shows them, and
    # the same with mesh["uvw"] their images.
    position = mesh["order"].copy()
    position[mesh["order"]] = range(len(position))
    meshio.Mesh(mesh["points"], [("tetra", mesh["cells"])], point_data={"uvw": mesh["uvw"]},
                cell_data={"position in the sweep": [position]}).write(tetrahedra_file)

    # 5. Write hexahedra.
    try:
        hexahedra = solid.hexahedra(1000)
    except vmp.Error as error:
        return f"no hexahedra: {error}"
    meshio.Mesh(hexahedra["points"], [("hexahedron", hexahedra["cells"])]).write(hexahedra_file)
    print(f"{len(mesh['cells'])} tetrahedra in {tetrahedra_file}, {len(hexahedra['cells'])} hexahedra in {hexahedra_file}")
    return 0


if __name__ == "__main__":
    if "--help" in sys.argv or "-h" in sys.argv:
        print(__doc__.strip())
    elif 2 <= len(sys.argv) <= 4:
        sys.exit(main(*sys.argv[1:]))
    else:
        print(__doc__.strip(), file=sys.stderr)
        sys.exit(2)
