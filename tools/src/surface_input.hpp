/// \file
/// Any file the command takes as a surface.
#pragma once

#include <tightflip/geometry/triangle_soup.hpp>
#include <tightflip/kernel/surface_text.hpp>

#include <string>
#include <variant>

#include <CLI/CLI.hpp>

namespace tightflip::tools {

/// How to take a file; added to every verb that reads surfaces.
struct InputOptions {
    bool triangulate = false;
    bool reorient = false;

    void add_triangulate(CLI::App& verb);
    void add_reorient(CLI::App& verb);
};

/// A file that could be read; whether it is a valid surface is for the audit to say.
class SurfaceInput {
public:
    /// Throws kernel::FileError where the file cannot be understood.
    SurfaceInput(const std::string& path, const InputOptions& options);

    [[nodiscard]] const std::string& format() const noexcept { return format_; }
    /// The audit, together with what a face list leaves undetermined.
    [[nodiscard]] kernel::AuditReport audit() const;
    /// The place of a violation, with the line or byte of the file where it is known.
    [[nodiscard]] std::string where(const kernel::Violation& violation) const;
    /// The surface. Throws kernel::FileError with the first violation, and for a mesh whose faces
    /// are not coherently oriented unless asked to turn them over.
    [[nodiscard]] kernel::Triangulation triangulation() const;
    /// The surface as a halfedge table: one that a file gives as it stands, for others to judge;
    /// else that of `triangulation`, which throws as that does.
    [[nodiscard]] kernel::RawTable table() const;

private:
    struct Mesh {
        geometry::TriangleSoup soup;
        kernel::FaceListReading reading;
    };

    std::string path_;
    InputOptions options_;
    std::string format_;
    std::variant<kernel::RawSurface, Mesh> content_;
};

}  // namespace tightflip::tools
