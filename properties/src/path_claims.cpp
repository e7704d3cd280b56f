#include <tightflip/kernel/connect.hpp>
#include <tightflip/kernel/shorten.hpp>
#include <tightflip/kernel/surface_equality.hpp>
#include <tightflip/properties/claims.hpp>
#include <tightflip/properties/path_claims.hpp>

namespace tightflip::properties {

std::optional<Finding> path_leads_to(const kernel::FlipLog& path, const Triangulation& from,
                                     const Triangulation& to, std::int64_t most) {
    if (auto finding = topology_is_preserved(path.start, path.flips, 0)) return finding;
    const kernel::Replay replayed = replay(path);
    const auto length = static_cast<std::int64_t>(path.flips.size());
    if (path.start == from && replayed.is_complete() && length <= most &&
        same_labelled_surface(replayed.surface, to)) {
        return std::nullopt;
    }
    return Finding{
        replayed.done,
        {.code = ViolationCode::path_does_not_connect, .found = length, .expected = most}};
}

std::optional<Finding> any_two_spheres_connect(const Triangulation& from, const Triangulation& to) {
    const std::int64_t most = kernel::connect_bound(from.vertex_count());
    const kernel::ConnectResult result = kernel::connect(from, to);
    if (!result) {
        return Finding{0, {.code = ViolationCode::path_does_not_connect, .expected = most}};
    }
    return path_leads_to(result.value(), from, to, most);
}

std::optional<Finding> shortening_keeps_the_ends(const Triangulation& start,
                                                 std::span<const Edge> script) {
    kernel::RecordedSurface recorded(start);
    for (const Edge e : script)
        static_cast<void>(recorded.flip(e));
    return path_leads_to(kernel::shorten(recorded.log()), start, recorded.surface(),
                         static_cast<std::int64_t>(recorded.log().flips.size()));
}

}  // namespace tightflip::properties
