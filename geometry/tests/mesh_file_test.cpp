#include "reading.hpp"
#include "samples.hpp"
#include <tightflip/geometry/mesh_file.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace tightflip::geometry {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for a test, gone with it.
class MeshFile : public testing::Test {
protected:
    MeshFile() {
        std::string name = (fs::path(testing::TempDir()) / "tightflip-XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    ~MeshFile() override { fs::remove_all(folder_); }

    fs::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }
    /// The reason for which a path is refused.
    static std::string refusal(const fs::path& path) {
        try {
            (void)read_mesh_file(path);
        } catch (const FileError& error) {
            EXPECT_EQ(error.source(), path.string());
            return error.reason();
        }
        return "was read";
    }

    fs::path folder_;
};

TEST_F(MeshFile, ReadsEveryFormatUnderItsNameAndUnderNone) {
    for (const auto& sample : samples::all()) {
        for (const std::string& name : {sample.name, std::string("mesh"), std::string("x.dat")}) {
            SCOPED_TRACE(sample.name + " as " + name);
            const auto soup = read_mesh_file(write(name, sample.bytes));
            EXPECT_EQ(soup.triangles.size(), 4U);
            EXPECT_EQ(soup.points.size(), 4U);
            EXPECT_EQ(soup.source, (folder_ / name).string());
        }
    }
}

TEST_F(MeshFile, TrustsTheContentMoreThanTheName) {
    expect_tetrahedron(read_mesh_file(write("a.stl", samples::off())));
    expect_tetrahedron(read_mesh_file(write("a.off", samples::ply_ascii())));
    expect_tetrahedron(read_mesh_file(write("a.ply", samples::obj())));
}

TEST_F(MeshFile, TrustsTheOptionMost) {
    const auto path = write("a.obj", samples::off());
    EXPECT_THROW((void)read_mesh_file(path, {.format = MeshFormat::obj}), FileError);
    expect_tetrahedron(read_mesh_file(path, {.format = MeshFormat::off}));
}

TEST_F(MeshFile, SaysWhatIsWrongWithAPath) {
    EXPECT_THAT(refusal(folder_ / "none.obj"), testing::HasSubstr("No such file"));
    EXPECT_THAT(refusal(folder_), testing::HasSubstr("directory"));
    EXPECT_THAT(refusal(write("empty.obj", "")), testing::HasSubstr("empty"));
    EXPECT_THAT(refusal(write("a.obj", "v 0 0 0\n") / "b.obj"),
                testing::HasSubstr("ot a directory"));
}

TEST_F(MeshFile, SaysThatAFileMayNotBeRead) {
    const auto path = write("secret.obj", samples::obj());
    fs::permissions(path, fs::perms::none);
    if (std::ifstream(path)) GTEST_SKIP() << "this user may read every file";
    EXPECT_THAT(refusal(path), testing::HasSubstr("Permission denied"));
}

TEST_F(MeshFile, SaysThatTheFormatIsUnknown) {
    EXPECT_THAT(refusal(write("mesh.xyz", "\x01\x02\x03")), testing::HasSubstr("OBJ, OFF, PLY"));
    EXPECT_THAT(refusal(write("mesh", "hello world")), testing::HasSubstr("name the format"));
    EXPECT_EQ(detect_mesh_format("hello", "mesh"), std::nullopt);
    EXPECT_EQ(detect_mesh_format("hello", "mesh.StL"), MeshFormat::stl);
}

TEST(MeshFormat, IsCalledByItsExtension) {
    for (const auto format : {MeshFormat::obj, MeshFormat::off, MeshFormat::ply, MeshFormat::stl}) {
        EXPECT_EQ(detect_mesh_format("?", "a." + std::string(name(format))), format);
    }
}

TEST(MeshFileError, ReadsAsCompilersWriteIt) {
    try {
        (void)read_mesh("v 0 0 0\nv 1 0 x\n", "mesh.obj");
        FAIL();
    } catch (const FileError& error) {
        EXPECT_STREQ(error.what(),
                     "mesh.obj:2: the z coordinate should be a number, but 'x' is none");
    }
}

}  // namespace
}  // namespace tightflip::geometry
