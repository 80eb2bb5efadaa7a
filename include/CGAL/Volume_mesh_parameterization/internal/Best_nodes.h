// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BEST_NODES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BEST_NODES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The nodes of the least grade that has been offered.
template <typename Grade>
class Best_nodes {
public:
  Best_nodes(const std::vector<Eigen::Vector3d>& nodes, const Grade& grade) : m_nodes(nodes), m_grade(grade) {}

  // Returns whether that is better.
  bool offer(const std::vector<Eigen::Vector3d>& nodes, const Grade& grade) {
    if (!(grade < m_grade)) return false;
    m_nodes = nodes;
    m_grade = grade;
    return true;
  }

  const Grade& grade() const { return m_grade; }
  const std::vector<Eigen::Vector3d>& nodes() const { return m_nodes; }

private:
  std::vector<Eigen::Vector3d> m_nodes;
  Grade m_grade;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BEST_NODES_H
