// What each kernel does, found by running it: a change here is news, and belongs in
// docs/conformance.md.
#include "kernels.hpp"

#include <tightflip/kernel/file_io.hpp>
#include <tightflip/properties/conformance.hpp>

#include <cctype>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

struct Expected {
    KernelDescription (*kernel)(KernelClass);
    KernelClass allowed;
    std::vector<int> codes;
};

KernelDescription ours(KernelClass) {
    return our_kernel();
}
KernelDescription broken(KernelClass) {
    return broken_kernel();
}
KernelDescription on_boost_graph(KernelClass) {
    return boost_graph_kernel();
}

constexpr auto simple = KernelClass::simple;
constexpr auto loopless = KernelClass::loopless;
constexpr auto delta = KernelClass::delta_complex;

const std::vector<Expected>& expectations() {
    static const std::vector<Expected> all{
        {ours, loopless, {}},
        {broken, loopless, {201, 401, 902}},
        {on_boost_graph, simple, {}},
        {cgal_surface_mesh, simple, {701, 801, 814}},
        {cgal_surface_mesh, loopless, {701, 801, 814, 901}},
        {cgal_surface_mesh, delta, {701}},
        {cgal_polygon_mesh, simple, {701, 801}},
        {cgal_polygon_mesh, loopless, {701, 901}},
        {cgal_polygon_mesh, delta, {701, 802}},
        {cgal_polyhedron, simple, {701, 801}},
        {cgal_polyhedron, loopless, {701, 901}},
        {cgal_polyhedron, delta, {701, 802}},
        {cgal_triangulation_data_structure, simple, {701, 801, 811, 813, 814}},
        {cgal_triangulation_data_structure, loopless, {201, 401, 701, 801, 811, 813, 901}},
        {cgal_triangulation_data_structure, delta, {201, 401, 801, 811, 813}},
        {open_mesh, simple, {811, 1003}},
        {open_mesh, loopless, {702, 811, 901, 1003}},
        {open_mesh, delta, {702, 811, 1003}},
        {open_mesh_by_hand, simple, {701, 801, 811, 1003}},
        {open_mesh_by_hand, loopless, {701, 811, 901, 1003}},
        {open_mesh_by_hand, delta, {802, 811, 1003}},
    };
    return all;
}

/// The report's row of the table.
std::string row(const KernelReport& report) {
    std::ostringstream table;
    write_markdown(table, std::span(&report, 1));
    const std::string text = table.str();
    return text.substr(text.rfind('\n', text.size() - 2) + 1);
}

class KernelConformance : public ::testing::TestWithParam<std::size_t> {};

TEST_P(KernelConformance, IsAsDocumented) {
    const Expected& expected = expectations()[GetParam()];
    ConformanceOptions options;
    options.scripts = 2;
    options.seconds = 1;
    options.most_hangs = 1;
    const KernelReport report = test_kernel(expected.kernel(expected.allowed), options);
    std::vector<int> codes;
    std::string words;
    for (const KernelFinding& finding : report.findings) {
        codes.push_back(static_cast<int>(finding.code));
        words += describe(finding) + "\n";
    }
    EXPECT_EQ(codes, expected.codes)
        << report.kernel << ", judged as " << name(report.allowed) << "\n"
        << words;
    EXPECT_THAT(kernel::read_file(TIGHTFLIP_CONFORMANCE_TABLE), ::testing::HasSubstr(row(report)));
}

INSTANTIATE_TEST_SUITE_P(Kernels, KernelConformance,
                         ::testing::Range<std::size_t>(0, expectations().size()),
                         [](const auto& parameter) {
                             const Expected& expected = expectations()[parameter.param];
                             const KernelDescription kernel = expected.kernel(expected.allowed);
                             std::string text;
                             for (const char c :
                                  kernel.name + "_" + std::string(name(expected.allowed)))
                                 text += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
                             return text;
                         });

TEST(AllKernels, AreThoseExpected) {
    EXPECT_EQ(all_kernels().size(), expectations().size());
}

}  // namespace
}  // namespace tightflip::properties
