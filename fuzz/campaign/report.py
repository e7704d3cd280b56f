"""The report of a campaign."""

from campaign import corpus, durable, line_coverage
from campaign.campaign import hours
from campaign.document import Code, Heading, Paragraph, Table, to_html, to_markdown

TITLE = "Fuzz campaign"
_MOST_SCRIPT = 4000  # characters of a script in the report; the file has all


def write(campaign, coverage=None):
    """report.md and report.html in the campaign's directory. coverage: LineCoverage by name, 'all
    targets' first, or None."""
    blocks = [Heading(TITLE, 1), Paragraph(_summary(campaign)), _targets(campaign)]
    blocks += _findings(campaign)
    blocks += _unusable(campaign)
    blocks += coverage_blocks(coverage) if coverage else []
    path = campaign.directory / "report.md"
    durable.write_text(path, to_markdown(blocks))
    durable.write_text(path.with_suffix(".html"), to_html(TITLE, blocks))
    return path


def _summary(campaign):
    state, settings = campaign.state, campaign.settings
    ended = f" It ended early: {campaign.ended_by}." if campaign.ended_by else ""
    starts = "one start" if state.starts == 1 else f"{state.starts} starts"
    return (f"{hours(state.seconds)} of {hours(settings.seconds)} hours by the clock in {starts}, "
            f"{settings.jobs} job{'s' if settings.jobs != 1 else ''}; engine {state.engine}, built "
            f"by {state.compiler or 'others'}.{ended}")


def _targets(campaign):
    rows = []
    for name in campaign.settings.targets:
        state = campaign.state.target(name)
        size = len(corpus.inputs(campaign.directory / "corpus" / name))
        seeds = len(corpus.inputs(campaign.directory / "seeds" / name))
        rate = state.executions / state.seconds if state.seconds else 0
        rows.append([name, hours(state.seconds), f"{state.executions:,}", f"{rate:,.0f}",
                     f"{seeds:,}", f"{size:,}", f"{state.edges:,}",
                     len(campaign.findings.of(name))])
    return Table(["target", "time", "executions", "a second", "seeds", "corpus", "edges",
                  "findings"], rows)


def _findings(campaign):
    blocks = [Heading("Findings")]
    found = [one for name in campaign.settings.targets for one in campaign.findings.of(name)]
    if not found:
        return blocks + [Paragraph("None.")]
    for finding in found:
        place = campaign.findings.path(finding)
        shortest = campaign.findings.shortest(finding)
        script = (place / "script.txt").read_text(encoding="utf-8", errors="replace")
        again = "" if finding.reproduces else " It did not fail a second time."
        blocks += [
            Heading(f"{finding.target}: {finding.signature}", 3),
            Paragraph(f"A {finding.kind}, found {finding.times} "
                      f"time{'s' if finding.times != 1 else ''}.{again} The input: {shortest}, "
                      f"{shortest.stat().st_size} bytes; what the fuzzer prints of it: "
                      f"{place / 'output.txt'}."),
            Code(f"tightflip_fuzz replay {finding.target} {shortest}"),
            Code(script[:_MOST_SCRIPT])]
    return blocks


def _unusable(campaign):
    rows = [[name, file, why] for name in campaign.settings.targets
            for file, why in sorted(campaign.state.target(name).unusable.items())]
    if not rows:
        return []
    return [Heading("Inputs set aside"),
            Paragraph(f"They are in {campaign.directory / 'set-aside'}."),
            Table(["target", "file", "why"], rows)]


def coverage_blocks(coverage):
    """Line coverage by what was run, one row each, one column a layer."""
    rows = [[name, *(one.total(layer).text() for layer in line_coverage.LAYERS)]
            for name, one in coverage.items()]
    return [Heading("Line coverage"), Table(["by", *line_coverage.LAYERS], rows)]


def file_blocks(coverage, layer):
    """One row a file, the worst first, with the lines that were missed."""
    counts = {name: coverage.count(name) for name in coverage.files(layer)}
    rows = [[name, count.lines, f"{count.percent():.2f} %",
             line_coverage.ranges(coverage.missed(name))]
            for name, count in sorted(counts.items(), key=lambda pair: pair[1].percent())]
    rows.append([f"{layer}, all", coverage.total(layer).lines,
                 f"{coverage.total(layer).percent():.2f} %", ""])
    return [Heading(f"{layer}: {coverage.total(layer).text()}", 3),
            Table(["file", "lines", "covered", "missed"], rows)]
