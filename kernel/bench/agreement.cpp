#include "bare_kernels.hpp"
#include "own_kernels.hpp"
#include "peer_kernels.hpp"
#include "suites.hpp"

namespace tightflip::kernel::bench {
namespace {

constexpr Index vertices = 500;
constexpr std::size_t attempts = 20'000;

struct Outcome {
    std::size_t done;
    FaceList faces;
    friend bool operator==(const Outcome&, const Outcome&) = default;
};

template <class Kernel>
Outcome outcome(const Triangulation& start, const std::vector<Edge>& edges) {
    Kernel kernel(start);
    std::vector<Edge> script(edges.begin(), edges.begin() + attempts);
    if constexpr (requires { kernel.translated(script); }) script = kernel.translated(script);
    const std::size_t done = kernel.flip_each(script);
    return {done, sorted_faces(kernel.faces())};
}

template <class... Kernels>
void compare(const Triangulation& start, const std::vector<Edge>& edges, const Outcome& expected,
             std::vector<std::string>& differing) {
    const auto compare_one = [&]<class Kernel>(Kernel*) {
        if (outcome<Kernel>(start, edges) != expected) differing.emplace_back(Kernel::name);
    };
    (compare_one(static_cast<Kernels*>(nullptr)), ...);
}

}  // namespace

std::vector<std::string> disagreements() {
    std::vector<std::string> differing;
    const Triangulation& multigraph = multigraph_sphere(vertices);
    const std::vector<Edge>& legal = flippable_edges(vertices);
    compare<Batched, WithVertexMap, BareRecords, BareArrays, BareFaceRecords, BareSideArrays,
            CgalUnchecked, OpenMeshUnchecked>(multigraph, legal,
                                              outcome<OneByOne>(multigraph, legal), differing);
    const std::vector<Edge>& any = random_edges(multigraph);
    compare<Batched, WithVertexMap, CgalDistinctCorners>(
        multigraph, any, outcome<OneByOne>(multigraph, any), differing);
    const Triangulation& simple = simple_sphere(vertices);
    const std::vector<Edge>& any_of_simple = random_edges(simple);
    compare<OpenMeshSimple, OpenMeshSimpleInline>(
        simple, any_of_simple, outcome<CgalSimple>(simple, any_of_simple), differing);
    return differing;
}

}  // namespace tightflip::kernel::bench
