#include "cromer/report/tidy_svg.h"

#include <fmt/format.h>

#include <charconv>
#include <iterator>
#include <optional>
#include <vector>

#include "cromer/base/ascii.h"
#include "cromer/report/escape.h"

namespace cromer {
namespace {

struct Tag {
  std::string_view name;  // "/g" for an end
  std::vector<std::pair<std::string_view, std::string_view>> attributes;
  bool closed = false;  // <path …/>

  std::optional<std::string_view> get(std::string_view key) const {
    for (const auto& [name_, value] : attributes) {
      if (name_ == key) return value;
    }
    return std::nullopt;
  }
};

constexpr std::string_view blanks = " \t\r\n";

// The tag between '<' and '>'.
Tag parse(std::string_view text) {
  Tag tag;
  if (!text.empty() && text.back() == '/') tag.closed = true, text.remove_suffix(1);
  std::size_t i = std::min(text.find_first_of(blanks), text.size());
  tag.name = text.substr(0, i);
  while ((i = text.find_first_not_of(blanks, i)) != std::string_view::npos) {
    const std::size_t equals = text.find('=', i);
    if (equals == std::string_view::npos) break;
    const std::size_t quote = text.find_first_of("'\"", equals);
    if (quote == std::string_view::npos) break;
    const std::size_t end = text.find(text[quote], quote + 1);
    if (end == std::string_view::npos) break;
    tag.attributes.emplace_back(trimmed(text.substr(i, equals - i)), text.substr(quote + 1, end - quote - 1));
    i = end + 1;
  }
  return tag;
}

std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  const char *p = text.data(), *end = p + text.size();
  while (p < end) {
    double value = 0;
    const auto [next, error] = std::from_chars(p, end, value);
    if (error == std::errc())
      numbers.push_back(value), p = next;
    else
      ++p;
  }
  return numbers;
}

// "rgb( 23,  28,  36)", "black" -> "#171C24", "#000000"
std::string hex(std::string_view colour) {
  if (colour.substr(0, 4) == "rgb(") {
    const auto rgb = numbers_in(colour);
    if (rgb.size() == 3)
      return fmt::format("#{:02X}{:02X}{:02X}", static_cast<int>(rgb[0]), static_cast<int>(rgb[1]),
                         static_cast<int>(rgb[2]));
  }
  return colour == "black" ? "#000000" : std::string(colour);
}

// "12.50" -> "12.5"
std::string shorter(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

// Path data as gnuplot writes them, " L" left out where SVG needs none, numbers without trailing zeros.
std::string shorter_path(std::string_view d) {
  std::string out;
  const char *p = d.data(), *end = p + d.size();
  bool after_number = false;
  while (p < end) {
    double value = 0;
    const auto [next, error] = std::from_chars(p, end, value);
    if (error == std::errc()) {
      if (after_number) out += ' ';
      out += shorter(value);
      after_number = true;
      p = next;
      continue;
    }
    if (*p == 'M' || *p == 'Z' || *p == 'z' || *p == 'L') {
      if (*p != 'L') out += *p, after_number = false;  // after M, further pairs are lines
    } else if (*p >= 'A' && *p <= 'z') {
      out += *p, after_number = false;
    }
    ++p;
  }
  return out;
}

// Text of gnuplot, which leaves > as it is: XML has no ]]> in text.
std::string closed(std::string_view text) {
  std::string out;
  for (const char c : text) c == '>' ? out += "&gt;" : out += c;
  return out;
}

class Tidy {
 public:
  explicit Tidy(std::string_view source) : source_(source) {}

  std::string rewrite(std::string_view alternative_text) {
    std::size_t i = 0;
    while ((i = source_.find('<', i)) != std::string_view::npos) {
      if (source_.substr(i, 4) == "<!--") {
        i = std::min(source_.find("-->", i), source_.size());
        continue;
      }
      const std::size_t end = source_.find('>', i);
      if (end == std::string_view::npos) break;
      const Tag tag = parse(source_.substr(i + 1, end - i - 1));
      i = end + 1;
      if ((tag.name == "defs" || tag.name == "title" || tag.name == "desc") && !tag.closed) {
        i = std::min(source_.find("</" + std::string(tag.name), i), source_.size());
      } else if (tag.name == "text") {
        const std::size_t stop = std::min(source_.find("</text>", i), source_.size());
        words(source_.substr(i, stop - i));
        i = stop;
      } else {
        element(tag);
      }
    }
    end_dots();
    const std::vector<double> box = numbers_in(view_box_);
    const double w = box.size() == 4 ? box[2] : 0, h = box.size() == 4 ? box[3] : 0;
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "role=\"img\" aria-label=\"{2}\" "
        "font-family=\"'Segoe UI', -apple-system, Roboto, 'Noto Sans', Lato, sans-serif\" "
        "stroke-linejoin=\"round\" fill=\"none\">\n{3}</svg>\n",
        shorter(w), shorter(h), escaped(alternative_text), out_);
  }

 private:
  struct Group {
    std::string_view color, stroke, fill, width, font_size, anchor, transform;
  };

  void element(const Tag& tag) {
    if (tag.name == "svg") {
      view_box_ = tag.get("viewBox").value_or("");
    } else if (tag.name == "g" && !tag.closed) {
      Group group = groups_.empty() ? Group{} : groups_.back();
      group.transform = {};
      const auto take = [&](std::string_view key, std::string_view& place) {
        if (const auto value = tag.get(key)) place = *value;
      };
      take("color", group.color), take("stroke", group.stroke), take("fill", group.fill),
          take("stroke-width", group.width);
      take("font-size", group.font_size), take("text-anchor", group.anchor),
          take("transform", group.transform);
      groups_.push_back(group);
    } else if (tag.name == "/g") {
      if (!groups_.empty()) groups_.pop_back();
    } else if (tag.name == "use") {
      dot(tag);
    } else if (tag.name == "image") {
      picture(tag);
    } else if (tag.name == "path" || tag.name == "polygon" || tag.name == "polyline" || tag.name == "rect" ||
               tag.name == "circle") {
      shape(tag);
    }
  }

  std::string colour(std::optional<std::string_view> own, std::string_view inherited) const {
    std::string_view value = own.value_or(inherited);
    if (value == "currentColor") value = groups_.empty() ? "black" : groups_.back().color;
    return hex(value);
  }

  void shape(const Tag& tag) {
    end_dots();
    const Group group = groups_.empty() ? Group{} : groups_.back();
    fmt::format_to(std::back_inserter(out_), "<{}", tag.name);
    const auto fill = tag.get("fill");
    if (fill && *fill != "none") {
      fmt::format_to(std::back_inserter(out_), " fill=\"{}\"", colour(fill, ""));
      if (const auto opacity = tag.get("fill-opacity"))
        fmt::format_to(std::back_inserter(out_), " fill-opacity=\"{}\"", shorter(numbers_in(*opacity)[0]));
    } else if (!group.stroke.empty() && (group.stroke != "none" || tag.get("stroke"))) {
      fmt::format_to(std::back_inserter(out_), " stroke=\"{}\" stroke-width=\"{}\"",
                     colour(tag.get("stroke"), group.stroke),
                     shorter(numbers_in(group.width.empty() ? "1" : group.width)[0]));
      if (const auto dashes = tag.get("stroke-dasharray"))
        fmt::format_to(std::back_inserter(out_), " stroke-dasharray=\"{}\"", *dashes);
    }
    for (const auto& [name, value] : tag.attributes) {
      if (name == "d")
        fmt::format_to(std::back_inserter(out_), " d=\"{}\"", shorter_path(value));
      else if (name == "points")
        points(value);
      else if (name == "x" || name == "y" || name == "width" || name == "height" || name == "cx" ||
               name == "cy" || name == "r" || name == "transform")
        fmt::format_to(std::back_inserter(out_), " {}=\"{}\"", name, trimmed(value));
    }
    out_ += "/>\n";
  }

  // A map's cells, inside the file; sharp at every size.
  void picture(const Tag& tag) {
    end_dots();
    out_ += "<image style=\"image-rendering:pixelated\"";
    for (const auto& [name, value] : tag.attributes)
      fmt::format_to(std::back_inserter(out_), " {}=\"{}\"", name == "xlink:href" ? "href" : name, value);
    out_ += "/>\n";
  }

  void points(std::string_view value) {
    out_ += " points=\"";
    const auto numbers = numbers_in(value);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (i > 0) out_ += ' ';
      out_ += shorter(numbers[i]);
    }
    out_ += '"';
  }

  // <use … transform='translate(x,y) scale(r)' color='…'/>: a disc of radius r.
  void dot(const Tag& tag) {
    const auto place = numbers_in(tag.get("transform").value_or(""));
    if (place.size() < 2) return;
    const std::string key = colour(tag.get("color"), "black") + "\" stroke-width=\"2.6";  // r 1.3 px
    if (key != dots_) {
      end_dots();
      dots_ = key;
      fmt::format_to(std::back_inserter(out_), "<path stroke=\"{}\" stroke-linecap=\"round\" d=\"", key);
    }
    fmt::format_to(std::back_inserter(out_), "M{} {}h0", shorter(place[0]), shorter(place[1]));
  }

  void end_dots() {
    if (!dots_.empty()) out_ += "\"/>\n";
    dots_.clear();
  }

  // The spans of a text without their font; plain spans without their tag.
  void words(std::string_view spans) {
    end_dots();
    const Group group = groups_.empty() ? Group{} : groups_.back();
    fmt::format_to(std::back_inserter(out_),
                   "<text transform=\"{}\" fill=\"{}\" font-size=\"{}\" text-anchor=\"{}\">", group.transform,
                   colour(std::nullopt, group.fill),
                   shorter(numbers_in(group.font_size.empty() ? "13" : group.font_size)[0]),
                   group.anchor.empty() ? "start" : group.anchor);
    for (std::size_t i = 0; (i = spans.find('<', i)) != std::string_view::npos;) {
      const std::size_t end = spans.find('>', i);
      if (end == std::string_view::npos) break;
      const Tag tag = parse(spans.substr(i + 1, end - i - 1));
      i = end + 1;
      if (tag.name != "tspan") continue;
      const std::string text = closed(spans.substr(i, std::min(spans.find('<', i), spans.size()) - i));
      std::string attributes;
      for (const auto& [name, value] : tag.attributes) {
        if (name != "font-family" && name != "xml:space")
          fmt::format_to(std::back_inserter(attributes), " {}=\"{}\"", name, trimmed(value));
      }
      out_ += attributes.empty() ? text : fmt::format("<tspan{}>{}</tspan>", attributes, text);
    }
    out_ += "</text>\n";
  }

  std::string_view source_;
  std::string_view view_box_;
  std::vector<Group> groups_;
  std::string dots_;
  std::string out_;
};

}  // namespace

std::string tidy_svg(std::string_view from_gnuplot, std::string_view alternative_text) {
  return well_formed(Tidy(from_gnuplot).rewrite(alternative_text));
}

}  // namespace cromer
