/// \file
/// The conformance suite as GoogleTest cases. Only includers of this header need GoogleTest.
///
/// \code
///     INSTANTIATE_TYPED_TEST_SUITE_P(MyMesh, MeshKernelSuite, MyKernel);
/// \endcode
///
/// Every case is a property; one that nothing put to the test is skipped and says why. What is
/// found is printed with its script; where the environment variable TIGHTFLIP_FAILURES names a
/// directory, logs are left there. The cases run with the default options; for others call
/// `test_kernel`.
#pragma once

#include <tightflip/properties/conformance.hpp>
#include <tightflip/properties/failing_case.hpp>

#include <cstdlib>

#include <gtest/gtest.h>

namespace tightflip::properties {

/// Success, or the findings against a property with their scripts in words, or why there was no
/// question.
[[nodiscard]] inline ::testing::AssertionResult holds(const KernelReport& report,
                                                      KernelProperty property) {
    if (report.holds(property)) return ::testing::AssertionSuccess();
    if (!report.was_asked(property)) {
        return ::testing::AssertionFailure() << "not asked: " << why_not_asked(property);
    }
    std::string words = report.kernel + " does not keep: " + std::string(describe(property)) + '\n';
    for (const KernelFinding& finding : report.findings) {
        if (property_of(finding.code) != property) continue;
        const FailingCase failing{*finding.log, describe(finding), {}};
        words += std::getenv(failures_directory_variable) == nullptr
                     ? in_words(failing)
                     : written_and_in_words(report.kernel + "-" + std::string(name(finding.code)),
                                            failing) +
                           '\n';
    }
    return ::testing::AssertionFailure() << words;
}

template <class K>
class MeshKernelSuite : public ::testing::Test {
protected:
    static void expect(KernelProperty property) {
        static const KernelReport report = test_kernel(kernel_description<K>());
        if (!report.was_asked(property)) GTEST_SKIP() << "not asked: " << why_not_asked(property);
        EXPECT_TRUE(holds(report, property));
    }
};

TYPED_TEST_SUITE_P(MeshKernelSuite);

TYPED_TEST_P(MeshKernelSuite, HoldsItsStart) {
    this->expect(KernelProperty::reading);
}
TYPED_TEST_P(MeshKernelSuite, KeepsTopology) {
    this->expect(KernelProperty::topology);
}
TYPED_TEST_P(MeshKernelSuite, ChangesNothingElsewhere) {
    this->expect(KernelProperty::locality);
}
TYPED_TEST_P(MeshKernelSuite, FlipsDiagonals) {
    this->expect(KernelProperty::definition);
}
TYPED_TEST_P(MeshKernelSuite, FlipsBack) {
    this->expect(KernelProperty::inverse);
}
TYPED_TEST_P(MeshKernelSuite, KeepsHandles) {
    this->expect(KernelProperty::handles);
}
TYPED_TEST_P(MeshKernelSuite, SaysTruthfullyWhatMayBeFlipped) {
    this->expect(KernelProperty::legality);
}
TYPED_TEST_P(MeshKernelSuite, ValidatesTruthfully) {
    this->expect(KernelProperty::validator);
}
TYPED_TEST_P(MeshKernelSuite, AgreesStepByStep) {
    this->expect(KernelProperty::agreement);
}
TYPED_TEST_P(MeshKernelSuite, Survives) {
    this->expect(KernelProperty::survival);
}

REGISTER_TYPED_TEST_SUITE_P(MeshKernelSuite, HoldsItsStart, KeepsTopology, ChangesNothingElsewhere,
                            FlipsDiagonals, FlipsBack, KeepsHandles, SaysTruthfullyWhatMayBeFlipped,
                            ValidatesTruthfully, AgreesStepByStep, Survives);

}  // namespace tightflip::properties
