/// \file
/// Surfaces with points in files of every format: OBJ, OFF, PLY, STL and `tightflip-surface`; and
/// what a file without coordinates, or without a valid surface, still says.
#pragma once

#include <tightflip/geometry/mesh_writer.hpp>
#include <tightflip/geometry/repair.hpp>
#include <tightflip/geometry/surface.hpp>
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/surface_text.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

namespace tightflip::geometry {

/// How to take a file. By default nothing is changed, and what would need it is refused.
struct SurfaceFileOptions {
    bool triangulate_polygons = false;  ///< see MeshFileOptions
    bool reorient = false;              ///< turn faces of a mesh over to agree with the first
    RepairOptions repair{};             ///< of mesh files
};

/// A file that could be read; whether it is a valid surface is for the audit to say.
class SurfaceFile {
public:
    /// Throws FileError where the file cannot be read or understood, or is a flip log.
    explicit SurfaceFile(const std::filesystem::path& path, const SurfaceFileOptions& options = {});

    /// "obj", "off", "ply", "stl", "tightflip-surface", "tightflip-triangulation" or
    /// "tightflip-gluing".
    [[nodiscard]] const std::string& format() const noexcept { return format_; }
    /// What the repairs asked for did; empty where none were, or the file is no mesh.
    [[nodiscard]] const std::optional<RepairReport>& repairs() const noexcept { return repairs_; }
    /// The audit, together with what a face list leaves undetermined.
    [[nodiscard]] kernel::AuditReport audit() const;
    /// The place of a violation, with the line or byte of the file where it is known.
    [[nodiscard]] std::string where(const kernel::Violation& violation) const;
    /// The surface. Throws FileError with the first violation, and for a mesh whose faces are not
    /// oriented alike unless asked to turn them over.
    [[nodiscard]] Triangulation triangulation() const;
    /// The same with its points. Throws FileError for formats without coordinates too.
    [[nodiscard]] Surface surface() const;
    /// The surface as a halfedge table: one that a file gives as it stands, for others to judge;
    /// else that of `triangulation`, which throws as that does.
    [[nodiscard]] kernel::RawTable table() const;

private:
    struct Mesh {
        TriangleSoup soup;
        kernel::FaceListReading reading;
    };

    void read(const std::string& bytes);
    void read_mesh_bytes(const std::string& bytes);

    std::string path_;
    SurfaceFileOptions options_;
    std::string format_;
    std::variant<kernel::RawSurface, Mesh> content_;
    std::optional<std::vector<Point>> points_;  // of a tightflip-surface
    std::optional<RepairReport> repairs_;
};

/// The surface in a file of any format with coordinates. Throws FileError.
[[nodiscard]] Surface read_surface_file(const std::filesystem::path& path,
                                        const SurfaceFileOptions& options = {});

/// The formats that hold a surface with its points.
enum class SurfaceFormat : std::uint8_t { tightflip_surface, obj, off, ply, stl };

/// "tightflip-surface", "obj", "off", "ply" or "stl".
[[nodiscard]] std::string_view name(SurfaceFormat format);
[[nodiscard]] std::optional<SurfaceFormat> surface_format_named(std::string_view name);
/// By the name's extension: .obj, .off, .ply, .stl in any case; tightflip-surface for .tfs or none.
/// Empty for any other.
[[nodiscard]] std::optional<SurfaceFormat> surface_format_of(const std::filesystem::path& path);

/// Writes a surface through a temporary file that takes the name when it is complete. Without a
/// format, the one that the name's extension says. Throws FileError where the extension says none,
/// the format cannot hold the surface (see mesh_writer.hpp), or writing fails; what stood at `path`
/// is then as it was.
void write_surface_file(const std::filesystem::path& path, const SurfaceView& surface,
                        std::optional<SurfaceFormat> format = {},
                        const MeshWriteOptions& options = {});

}  // namespace tightflip::geometry
