#include "failures_directory.hpp"
#include "naive_kernel.hpp"
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/properties/conformance_suite.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest-spi.h>

namespace tightflip::properties {

INSTANTIATE_TYPED_TEST_SUITE_P(Naive, MeshKernelSuite, Naive<Fault::none>);

namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

const ConformanceOptions in_one_process{.isolate = false};

/// What the suite's case says of a property.
template <class K>
std::string said_of(KernelProperty property) {
    struct Case : MeshKernelSuite<K> {
        using MeshKernelSuite<K>::expect;
        void TestBody() override {}
    };
    ::testing::TestPartResultArray results;
    const ::testing::ScopedFakeTestPartResultReporter reporter(&results);
    Case::expect(property);
    if (results.size() == 0) return "holds";
    const ::testing::TestPartResult& result = results.GetTestPartResult(0);
    return (result.skipped() ? "skipped: " : "failed: ") + std::string(result.message());
}

TEST(ConformanceSuite, SkipsWhatNothingPutToTheTest) {
    using Unmade = Naive<Fault::cannot_be_made>;
    EXPECT_EQ(said_of<Naive<Fault::none>>(KernelProperty::inverse), "holds");
    EXPECT_THAT(said_of<Unmade>(KernelProperty::survival), HasSubstr("1001 threw"));
    EXPECT_THAT(said_of<Unmade>(KernelProperty::reading),
                AllOf(HasSubstr("skipped: "), HasSubstr("not asked: no start was made")));
    EXPECT_THAT(said_of<Unmade>(KernelProperty::topology),
                HasSubstr("not asked: no flip was done"));
    EXPECT_THAT(said_of<Unmade>(KernelProperty::validator),
                HasSubstr("not asked: it never met an invalid surface"));
}

TEST(ConformanceSuite, SaysOfWhatWasNotAskedNeitherThatItHoldsNorThatItDoesNot) {
    const auto result = holds(KernelReport{}, KernelProperty::inverse);
    EXPECT_FALSE(result);
    EXPECT_STREQ(result.message(), "not asked: no flip was taken back");
}

TEST(ConformanceSuite, WritesLogsThatShowTheFindingAgain) {
    const FailuresDirectory directory("conformance_suite");
    FailuresDirectory::name_instead(directory.path() / "not" / "there");
    const auto kernel = kernel_description<Naive<Fault::refuses_all>>();
    const auto result = holds(test_kernel(kernel, in_one_process), KernelProperty::legality);
    const auto path = directory.path() / "not" / "there" / "naive-valid_flip_refused.flips";
    EXPECT_THAT(result.message(), HasSubstr("702 valid_flip_refused, tetrahedron V=4, step 1: "));
    EXPECT_THAT(result.message(), HasSubstr("\nflip 1: edge 0 joins 0-1, becomes 3-2\n"));
    EXPECT_THAT(result.message(), EndsWith("written to " + path.string() + "\n"));

    const kernel::FlipLog log = kernel::parse_flip_log(kernel::read_file(path), path.string());
    const ScriptRun again = run_script(kernel, log.start, log.flips, false);
    EXPECT_EQ(again.findings.at(0).code, KernelCode::valid_flip_refused);
}

TEST(ConformanceSuite, ShowsTheFindingAlsoWhereItCannotBeWritten) {
    const FailuresDirectory directory("conformance_suite_unwritten");
    kernel::write_file(directory.path() / "file", [](std::ostream& out) { out << "no directory"; });
    FailuresDirectory::name_instead(directory.path() / "file");
    const KernelReport report =
        test_kernel(kernel_description<Naive<Fault::refuses_all>>(), in_one_process);
    const auto result = holds(report, KernelProperty::legality);
    EXPECT_THAT(result.message(), HasSubstr("702 valid_flip_refused"));
    EXPECT_THAT(result.message(), HasSubstr("flip 1: edge 0"));
    EXPECT_THAT(result.message(), HasSubstr("\nnot written: " + directory.path().string()));
}

}  // namespace
}  // namespace tightflip::properties
