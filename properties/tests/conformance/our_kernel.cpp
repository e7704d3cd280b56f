#include "kernels.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/quick_audit.hpp>

namespace tightflip::properties {
namespace {

using kernel::Halfedge;

/// The plain table under a Triangulation, which can be damaged, and the quick judge, which shares
/// no code with the audit that the suite asks.
struct OurKernel {
    static constexpr std::string_view name = "tightflip";
    static constexpr KernelClass allowed = KernelClass::loopless;
    using Side = Halfedge;

    OurKernel(Index vertex_count, std::span<const std::array<Index, 3>> faces)
        : OurKernel(kernel::build(faces, vertex_count).value()) {}
    explicit OurKernel(const Gluing& gluing) : OurKernel(kernel::build(gluing).value()) {}

    [[nodiscard]] std::array<Index, 3> counts() const {
        const auto halfedges = static_cast<Index>(records.size());
        return {vertices, halfedges / 2, halfedges / 3};
    }
    [[nodiscard]] std::vector<Side> sides() const {
        std::vector<Side> all;
        for (Index h = 0; h < static_cast<Index>(records.size()); ++h)
            all.push_back({h});
        return all;
    }
    [[nodiscard]] Side next(Side s) const { return at(kernel::HalfedgeTable(records), s).next; }
    [[nodiscard]] Side across(Side s) const { return twin(s); }
    [[nodiscard]] Index origin(Side s) const {
        return at(kernel::HalfedgeTable(records), s).origin.id;
    }
    [[nodiscard]] bool can_flip(Side s) const {
        return static_cast<bool>(kernel::can_flip(records, edge_of(s)));
    }
    void flip(Side s) { kernel::flip(records, edge_of(s)); }
    [[nodiscard]] bool is_valid() const { return kernel::passes_audit(records, vertices); }

    void set_origin(Side s, Index v) { record(s).origin = {v}; }
    void set_next(Side s, Side wrong) { record(s).next = wrong; }

    std::vector<kernel::HalfedgeRecord> records;
    Index vertices;

private:
    explicit OurKernel(const Triangulation& surface)
        : records(surface.table().begin(), surface.table().end()),
          vertices(surface.vertex_count()) {}
    kernel::HalfedgeRecord& record(Side s) { return at(kernel::MutableHalfedgeTable(records), s); }
};

/// Broken on purpose: it forgets one of the two labels that a flip rewrites.
struct ForgetfulKernel : OurKernel {
    static constexpr std::string_view name = "tightflip, a label forgotten";
    using OurKernel::OurKernel;

    void flip(Side s) {
        const Index forgotten = origin(s);
        OurKernel::flip(s);
        set_origin(s, forgotten);
    }
};

}  // namespace

KernelDescription our_kernel() {
    return kernel_description<OurKernel>();
}

KernelDescription broken_kernel() {
    return kernel_description<ForgetfulKernel>();
}

}  // namespace tightflip::properties
