// The images of the contenders at equal time beside the reference: whole, cut in two, enlarged, and
// as maps of what is wrong with them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/figure/film_series.h"
#include "draw/figure/map_panel.h"
#include "draw/report/contender_image.h"
#include "draw/report/crops.h"
#include "draw/report/embedding.h"
#include "draw/report/numbers.h"
#include "draw/report/picture_store.h"
#include "draw/report/sections.h"
#include "lab/compare/yardstick.h"
#include "lab/wording.h"
#include "records/tone.h"

namespace wander::report {
namespace {

constexpr std::size_t most_crops = 3, most_bytes_of_maps = 1'000'000;

struct Pictures {
  const Subject& subject;
  std::vector<ContenderImage> images;
  double white;

  const FilmEstimate& reference() const { return subject.runs().reference.film; }
  const std::string& label(const ContenderImage& image) const {
    return subject.label(image.contender);
  }
  const std::string& budget() const { return subject.runs().budgets[subject.comparison.decisive]; }
};

Pictures pictures_of(const Subject& subject) {
  Pictures pictures{subject, {}, white_of(subject.runs().reference.film)};
  for (std::size_t k = 0; k < subject.contenders(); ++k)
    if (auto image = image_of(subject, k)) pictures.images.push_back(*std::move(image));
  return pictures;
}

// ---- side by side

// Where the crops lie.
std::string frames_of(const std::vector<Crop>& crops, double width) {
  std::string frames;
  const double line = width / 160, size = width / 18;
  for (std::size_t k = 0; k < crops.size(); ++k) {
    const Crop& c = crops[k];
    for (const auto& [colour, stroke] :
         {std::pair("#000000", 2 * line), std::pair("#ffffff", line)})
      frames += fmt::format(
          R"(<rect x="{}" y="{}" width="{}" height="{}" fill="none" stroke="{}" stroke-width="{}"/>)",
          c.x, c.y, c.side, c.side, colour, figure::number(stroke));
    frames += fmt::format(
        R"(<text x="{}" y="{}" font-size="{}" font-weight="bold" fill="#ffffff" stroke="#000000" )"
        R"(stroke-width="{}" paint-order="stroke">{}</text>)",
        figure::number(static_cast<double>(c.x) + 2 * line),
        figure::number(static_cast<double>(c.y) + size), figure::number(size),
        figure::number(2 * line), k + 1);
  }
  return frames;
}

std::string words_of(const Pictures& pictures, const ContenderImage& image,
                     const compare::Yardstick& yardstick) {
  const compare::RunErrors errors = errors_of(image.run.film, yardstick);
  return fmt::format(": {} in {}; relMSE {}, RMSE {}, MAE {}",
                     image.run.seed_samples > 0
                         ? steps_in_words(image.run.samples, image.run.seed_samples)
                         : count_in_words(static_cast<double>(image.run.samples)) + " samples",
                     duration_in_words(image.run.time(pictures.subject.runs().time)),
                     rounded(errors.rel_mse), rounded(errors.rmse), rounded(errors.mae));
}

template <class Show>
void write_picture(Html& html, const std::string& label, const std::string& words, Show&& show) {
  const auto figure = html.open("figure");
  show();
  const auto caption = html.open("figcaption");
  html.markup(fmt::format("<strong>{}</strong>{}", figure::escaped(label), figure::escaped(words)));
}

void write_side_by_side(Html& html, const Pictures& pictures, PictureStore& store,
                        const std::vector<Crop>& crops) {
  const compare::Yardstick yardstick(pictures.subject.runs().reference);
  const auto gallery = html.open("div", {{"class", "gallery"}});
  for (std::size_t k = 0; k < pictures.images.size(); ++k) {
    const ContenderImage& image = pictures.images[k];
    write_picture(html, pictures.label(image), words_of(pictures, image, yardstick), [&] {
      store.show(html, k,
                 fmt::format("film of {} at {}", pictures.label(image), pictures.budget()));
    });
  }
  write_picture(html, "reference", crops.empty() ? "" : "; the frames are the parts below", [&] {
    store.show(html, pictures.images.size(), "film of the reference",
               frames_of(crops, store.width()));
  });
}

// ---- one over the other

// A box that can be drawn wider lies over the reference; the buttons do the same in three steps.
void write_split(Html& html, const Pictures& pictures, const PictureStore& store, std::size_t k) {
  const std::string& label = pictures.label(pictures.images[k]);
  const auto scope = html.open("fieldset", {{"class", "split"}});
  html.element("legend", fmt::format("{} and the reference", label));
  const auto button = [&](const char* kind, const std::string& text, const char* checked) {
    html.markup(
        fmt::format(R"(<input type="radio" name="split-{0}" id="split-{0}-{1}" class="{1}"{2}/>)",
                    k, kind, checked));
    html.element("label", text, {{"for", fmt::format("split-{}-{}", k, kind)}});
  };
  button("left", label, "");
  button("both", "both", R"( checked="checked")");
  button("right", "reference", "");
  const auto frame = html.open("div", {{"class", "frame"}});
  store.show(html, pictures.images.size(), "film of the reference");
  const auto over = html.open("div", {{"class", "over"}});
  store.show(html, k, fmt::format("film of {}", label));
}

// Paper cannot be drawn wider.
void write_splits(Html& html, const Pictures& pictures, const PictureStore& store) {
  const auto on_screen = html.open("div", {{"class", "on-screen"}});
  html.element("h3", "One over the other");
  html.element("p",
               "Each contender lies over the reference: drag the lower corner of the line between "
               "them, or choose one of the two.");
  const auto splits = html.open("div", {{"class", "splits"}});
  for (std::size_t k = 0; k < pictures.images.size(); ++k) write_split(html, pictures, store, k);
}

// ---- enlarged

void write_crops(Html& html, const Pictures& pictures, const std::vector<Crop>& crops) {
  if (crops.empty()) return;
  html.element("h3", "Where they differ most");
  html.element(
      "p", fmt::format("The parts in which what is seen of the contenders differs most from one to "
                       "another, {} by {} pixels each, chosen by the pictures alone.",
                       crops.front().side, crops.front().side));
  for (std::size_t n = 0; n < crops.size(); ++n) {
    const auto row = html.open("div", {{"class", "crops"}});
    const auto show = [&](const FilmEstimate& film, const std::string& label) {
      write_picture(html, fmt::format("{}", n + 1), fmt::format(" {}", label), [&] {
        write_enlarged(html, cropped(film, crops[n]), pictures.white,
                       fmt::format("part {} of the film of {}", n + 1, label));
      });
    };
    for (const ContenderImage& image : pictures.images) show(image.run.film, pictures.label(image));
    show(pictures.reference(), "reference");
  }
}

// ---- maps

void write_maps(Html& html, const Pictures& pictures) {
  std::vector<double> errors;
  std::vector<figure::PixelMap> differences;
  for (const ContenderImage& image : pictures.images) {
    errors.insert(errors.end(), image.error.values.begin(), image.error.values.end());
    differences.push_back(image.z);
  }
  const figure::ToneScale scale = figure::tone_scale(errors);
  const double most = figure::largest_shown(differences);
  const std::size_t n =
      pixels_to_one(pictures.reference(), 3, 2 * pictures.images.size(), most_bytes_of_maps);
  html.element("h3", "Where the errors are");
  for (const ContenderImage& image : pictures.images) {
    const std::string replicates = counted(image.replicates, "replicate");
    figure::Block row = figure::panel_row(
        figure::log_panel({fmt::format("{}: relative error", pictures.label(image)),
                           fmt::format("root mean square over {}", replicates)},
                          figure::thinned(image.error, n), scale,
                          {"relative error of a pixel", ""}),
        figure::difference_panel({fmt::format("{} − reference", pictures.label(image)),
                                  fmt::format("mean of {}", replicates)},
                                 figure::thinned(image.z, n), most),
        figure::block_width(figure_width));
    write_figure(
        html,
        figure::page("", fmt::format("Maps of the errors of {}.", pictures.label(image)),
                     figure_width, {std::move(row)}),
        &image != &pictures.images.front()
            ? fmt::format("The same of {}.", pictures.label(image))
            : "Left, the error of a pixel of one run, relative to the reference, on one scale for "
              "all contenders: bright is where the time goes, grey where the reference knows no "
              "more than the run. Right, the mean of all replicates "
              "less the reference, in units of what they let expect: without structure, and mostly "
              "within ±2 (with few replicates ±3), where a contender is right; a patch of one "
              "colour is light that all its runs miss or have too much of.",
        Ground::paper);
  }
}

}  // namespace

void write_pictures(Html& html, const Subject& subject) {
  const Pictures pictures = pictures_of(subject);
  if (pictures.images.empty()) return;
  const figure::Quantity value = figure::film_axes(subject.scene).value;
  html.element(
      "p",
      fmt::format("The first replicate of each contender at budget {}, the largest that all "
                  "have, beside the reference. All have one exposure: white is a luminance "
                  "of {} {}, which 99 % of the lit pixels of the reference do not exceed. RMSE "
                  "and MAE are in {}; all errors are means over channels.",
                  pictures.budget(), rounded(pictures.white), value.unit, value.unit));
  std::vector<const FilmEstimate*> films;
  for (const ContenderImage& image : pictures.images) films.push_back(&image.run.film);
  const std::vector<Crop> crops =
      choose_crops(films, pictures.reference(), pictures.white, most_crops);
  PictureStore store(pictures.reference(), films.size() + 1, pictures.white);
  for (const FilmEstimate* film : films) store.add(html, *film);
  store.add(html, pictures.reference());
  write_side_by_side(html, pictures, store, crops);
  write_crops(html, pictures, crops);
  write_splits(html, pictures, store);
  write_maps(html, pictures);
}

}  // namespace wander::report
