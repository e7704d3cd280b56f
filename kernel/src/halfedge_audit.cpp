#include <tightflip/kernel/halfedge_audit.hpp>
#include <tightflip/kernel/quick_audit.hpp>

namespace tightflip::kernel {
namespace {

/// What the ladder reports, without statistics, of a table that passes.
AuditReport passing_report(HalfedgeTable table, Index vertex_count) {
    AuditReport report;
    report.reached_top = true;
    report.coherently_stored = true;
    Topology& t = report.topology;
    t.vertices = vertex_count;
    t.edges = static_cast<Index>(table.size() / 2);
    t.faces = static_cast<Index>(table.size() / 3);
    t.components = 1;
    t.euler_characteristic = t.vertices - t.edges + t.faces;
    t.orientable = true;
    t.genus = (2 - t.euler_characteristic) / 2;
    return report;
}

}  // namespace

AuditReport audit(HalfedgeTable table, Index vertex_count, const AuditOptions& options) {
    if (!options.statistics && passes_audit(table, vertex_count)) {
        return passing_report(table, vertex_count);
    }
    return climb_audit_ladder(table, vertex_count, options);
}

}  // namespace tightflip::kernel
