/// \file
/// Small inputs, and what the tests know of them.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace tightflip::tools::samples {

using Faces = std::vector<std::vector<int>>;

inline const Faces tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

/// Its vertices stand on lines 3, 4, ..., its faces on the lines after them.
inline std::string off(int vertices, const Faces& faces) {
    std::string text =
        "OFF\n" + std::to_string(vertices) + " " + std::to_string(faces.size()) + " 0\n";
    for (int v = 0; v < vertices; ++v)
        text += std::to_string(v) + " " + std::to_string(v * v) + " 0.5\n";
    for (const auto& face : faces) {
        text += std::to_string(face.size());
        for (const int corner : face)
            text += " " + std::to_string(corner);
        text += "\n";
    }
    return text;
}

/// Faces as they are, and more of them.
inline Faces with(Faces faces, const Faces& more) {
    faces.insert(faces.end(), more.begin(), more.end());
    return faces;
}

/// The projective plane on six vertices: the icosahedron with opposite points made one.
inline const Faces projective_plane{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 1, 5},
                                    {1, 2, 4}, {1, 3, 4}, {1, 3, 5}, {2, 3, 5}, {2, 4, 5}};

/// A grid of 4 by 4 squares, closed in one direction as it is and in the other with a reflection.
inline Faces klein_bottle() {
    constexpr int n = 4;
    const auto vertex = [](int column, int row) {
        if (column == n) return (n - row % n) % n;
        return n * column + row % n;
    };
    Faces faces;
    for (int c = 0; c < n; ++c) {
        for (int r = 0; r < n; ++r) {
            faces.push_back({vertex(c, r), vertex(c + 1, r), vertex(c + 1, r + 1)});
            faces.push_back({vertex(c, r), vertex(c + 1, r + 1), vertex(c, r + 1)});
        }
    }
    return faces;
}

/// The tightflip-gluing format; the last argument is the lines of the faces.
inline std::string gluing(int vertices, const std::vector<std::string>& faces) {
    std::string text = "tightflip-gluing 1\nvertices " + std::to_string(vertices) + "\nfaces " +
                       std::to_string(faces.size()) + "\n";
    for (const std::string& face : faces)
        text += face + "\n";
    return text + "end\n";
}

/// Three vertices, two faces.
inline const std::string smallest_sphere = gluing(3, {"0 1 2  5 4 3", "0 2 1  2 1 0"});

}  // namespace tightflip::tools::samples
