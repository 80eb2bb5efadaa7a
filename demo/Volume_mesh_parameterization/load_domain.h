#ifndef HANDLEBODY_LOAD_DOMAIN_H
#define HANDLEBODY_LOAD_DOMAIN_H

#include "Stage_clock.h"
#include "commands.h"
#include "types.h"

#include <vector>

// Reads the polycube that the user gives, or makes that whose boundary is the image of the boundary of `solid`, and labels it.
// `images` are those of the vertices of `solid`.
VMP::Status load_domain(const Parameterize_options& options, const Mesh& solid, const std::vector<Point_3>& images,
                        Stage_clock& clock, Mesh& domain);

#endif // HANDLEBODY_LOAD_DOMAIN_H
