"""The parts of docs/figure4.md that tools/figure4 makes: the figure, the errors, the ratio."""
import shlex

from study.figure4_figure import METHOD_NAMES
from study.page import error_text, percent, power_of_ten, table
from study.runs import short


def command_of(options, *more):
    """What makes this again, on any machine."""
    words = ["tools/figure4", "--samples", ",".join(map(short, options.samples)),
             "--methods", ",".join(options.methods), "--scenes", ",".join(options.scenes),
             "--chunk", short(options.chunk), *more]
    for scene, path in sorted(options.references.items()):
        words += ["--reference", f"{scene}={path}"]
    return "    " + shlex.join(words)


def error_cells(row, key):
    """Relative RMSE, what the film claims of itself, reliable bins."""
    film, measured = row.films.get(key), row.relative_mse(key)
    if not film:
        return ["no film", "–", "–"]
    claims = percent(film.claimed_error()) if any(film.values) else "no light"
    part = "" if film.samples == key[1] else f" ({power_of_ten(film.samples)})"
    return [(error_text(*measured) if measured else "–") + part, claims, f"{sum(film.reliable)}/{len(film.reliable)}"]


def errors(options, rows):
    heads = ["scene", "method"]
    for samples in options.samples:
        heads += [f"{power_of_ten(samples)} samples", "claimed", "reliable"]
    body = [[row.scene, f"`{method}`", *(cell for n in options.samples for cell in error_cells(row, (method, n)))]
            for row in rows for method in options.methods]
    return table(heads, body)


def reference_line(row):
    """What the errors of the scene are measured against, the best film itself included."""
    best = row.reference()
    if not best:
        return f"* {row.scene}: none, since no film has seen light"
    own = next((key for key, parts in row.parts.items() if parts is best.parts), None)
    line, other = f"* {row.scene}: {described(best)}", row.reference([own])
    return f"{line}; itself measured against {described(other)}" if own and other else line


def described(reference):
    return f"{reference.name}, error {percent(reference.film.claimed_error())}"


def seed_passes(options, rows):
    """Bidirectional samples that Markov chain methods spent besides their mutations."""
    lines = []
    for method in options.methods:
        spent = [f"{power_of_ten(film.seed_samples)} ({row.scene}, {power_of_ten(film.samples)})" for row in rows
                 for (name, _), film in row.films.items() if name == method and film.seed_samples]
        if spent:
            lines.append(f"Seed passes of `{method}`, in bidirectional samples, besides its mutations: "
                         + "; ".join(spent) + ".")
    return lines


def results(options, rows):
    names = ", ".join(METHOD_NAMES[method] for method in options.methods)
    return "\n\n".join([f"![Irradiance on the sensor of the scenes {', '.join(options.scenes)} by {names}](figure4.svg)",
                        command_of(options), errors(options, rows), "References:", "\n".join(map(reference_line, rows)),
                        *seed_passes(options, rows)])


def interval(estimate):
    return f"{estimate.value:.2g} ({estimate.low:.2g}–{estimate.high:.2g})".replace("inf", "∞")


def ratio_text(options, contenders, rival, reference, estimates):
    """In words; rival is a merged film."""
    of_film, of_spread = estimates
    mutations = power_of_ten(contenders[0].samples)
    seed_pass = power_of_ten(round(sum(film.seed_samples for film in contenders) / len(contenders)))
    lines = [command_of(options, "--ratio", str(len(contenders)), *(["--mlt", options.mlt] if options.mlt else [])),
             f"On `{options.scenes[-1]}`, mean square error of `mlt` with {mutations} mutations and a seed pass of "
             f"{seed_pass} bidirectional samples ({len(contenders)} runs), over that of `bdpt` with "
             f"{power_of_ten(rival.samples)} samples. Intervals hold 95 %. Reference: {reference.name}, with a relative "
             f"error of {percent(reference.film.claimed_error())}, which is subtracted.",
             f"* Against this one film of `bdpt`: **{interval(of_film)}**."]
    if of_spread:
        lines.append(f"* Against its expected square error, from the spread of its {rival.runs} chunks: "
                     f"**{interval(of_spread)}**.")
    return "\n\n".join(lines)
