// SPDX-License-Identifier: MIT
// Shading normals of a mesh that its file leaves to the renderer.
#pragma once

#include "ir/math/vec.hpp"
#include "ir/scene/assets.hpp"

namespace cobble::ir {

/// How the normals of a mesh come about.
enum class NormalRule : std::uint8_t {
    /// Faces that share an edge and meet at less than the crease angle are shaded as one surface:
    /// around each vertex such faces form groups, and a group has one normal, the sum of its
    /// faces' unit normals weighted by their angles at the vertex (Thürmer and Wüthrich,
    /// "Computing vertex normals from polygonal facets", 1998), which does not depend on how a
    /// polygon was cut. Groups, rather than a test of each pair of faces, make the shading
    /// continuous across every smooth edge. Vertices at one place count as one.
    kCreaseAngle,
    kSumOfCrosses,  ///< per vertex, the sum of un-normalised cross products (2012)
    kSumOfUnits,    ///< per vertex, the sum of unit face normals (2016)
    kFlat,
};

/// Replaces the normals of `mesh`. A face has normals at all its corners or (shaded flat) at none.
/// `crease_angle` is in degrees, [0, 180], for kCreaseAngle only: "less than" is exact at 0, 90 and
/// 180. Degenerate faces neither give nor get normals.
///
/// Cost: proportional to the faces, times the logarithm of the largest number at one vertex.
void compute_normals(Mesh& mesh, NormalRule rule, double crease_angle);

/// Makes the file's own normals unit; faces that use one without length become flat.
void adopt_normals(Mesh& mesh);

/// Of unit length whatever the input's size; zero stays zero.
math::Vec3d safe_normalize(math::Vec3d v);

/// False if the three points lie on one line, or nearly so far out that it cannot be told.
bool has_area(math::Vec3d a, math::Vec3d b, math::Vec3d c);

/// The unit normal of a face, counter-clockwise from the front; zero for a degenerate face.
math::Vec3d face_normal(const Mesh& mesh, const Mesh::Face& face);

}  // namespace cobble::ir
