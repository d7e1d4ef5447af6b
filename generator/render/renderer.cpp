// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <render/renderer.hpp>

#include <algorithm>
#include <utility>
#include <vector>

#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

namespace oroforge::render {

namespace {

namespace mustache = kainjow::mustache;

/// The engine looks up {{x}} and {{#x}} alike. The mark, which no key has, shows the former: these must exist.
constexpr char kVariableMark = '$';

/// Marks a line with nothing but a section, partial or comment tag; such lines leave no trace in the output. (The
/// engine drops them only if it enters the section.)
constexpr char kTagLine = '\x01';

bool isPresent(const nlohmann::json& value) {
    if (value.is_string()) return !value.get_ref<const std::string&>().empty();
    return !(value.is_null() || (value.is_boolean() && !value.get<bool>()));
}

mustache::data toData(const nlohmann::json& value) {
    if (value.is_object()) {
        mustache::data object(mustache::data::type::object);
        for (const auto& [key, item] : value.items()) object[key] = toData(item);
        return object;
    }
    if (value.is_array()) {
        mustache::data list(mustache::data::type::list);
        // The engine's own push_back() copies everything below at each level.
        auto& items = const_cast<mustache::list&>(list.list_value());
        for (const auto& item : value) items.push_back(toData(item));
        return list;
    }
    if (!isPresent(value)) return mustache::data(false);
    if (value.is_string()) return mustache::data(value.get<std::string>());
    if (value.is_boolean()) return mustache::data(true);
    return mustache::data(value.dump());
}

std::string trimmed(const std::string& text) {
    const auto begin = text.find_first_not_of(" \t\n");
    return begin == std::string::npos ? std::string() : text.substr(begin, text.find_last_not_of(" \t\n") - begin + 1);
}

/// Turns {{x}} and {{{x}}} into {{&$x}}: never escaped, and recognisable as variables.
std::string markVariables(const std::string& text) {
    std::string result;
    std::size_t at = 0;
    for (std::size_t open; (open = text.find("{{", at)) != std::string::npos;) {
        result.append(text, at, open - at);
        const bool triple = text.compare(open, 3, "{{{") == 0;
        const std::string end = triple ? "}}}" : "}}";
        const std::size_t begin = open + end.size();
        const std::size_t close = text.find(end, begin);
        if (close == std::string::npos) return result + text.substr(open);
        const std::string content = trimmed(text.substr(begin, close - begin));
        const bool special =
            !triple && !content.empty() && std::string("#^/!>=&").find(content[0]) != std::string::npos;
        result += "{{" + (special ? content : std::string("&") + kVariableMark + content) + "}}";
        at = close + end.size();
    }
    return result + text.substr(at);
}

bool isTagLine(const std::string& line) {
    const std::string tag = trimmed(line);
    return tag.size() > 4 && tag.compare(0, 2, "{{") == 0 && std::string("#^/!>").find(tag[2]) != std::string::npos &&
           tag.find("}}") == tag.size() - 2;
}

std::string markTagLines(const std::string& text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        result += isTagLine(line) ? trimmed(line) + kTagLine : line;
        if (end < text.size()) result += '\n';
        at = end + 1;
    }
    return result;
}

constexpr int kDeepest = 20;

/// Inserts the texts of partials, because the engine would parse them again each time.
std::string withPartials(const std::string& text, const Templates& templates, const std::string& name, int depth = 0) {
    if (depth == kDeepest) throw RenderError(name + ": partials include each other without end");
    std::string result;
    std::size_t at = 0;
    for (std::size_t open; (open = text.find("{{>", at)) != std::string::npos;) {
        const std::size_t close = text.find("}}", open);
        if (close == std::string::npos) break;
        const std::string partial = trimmed(text.substr(open + 3, close - open - 3));
        const std::string* found = templates.find(partial);
        if (found == nullptr) throw RenderError(name + ": no partial '" + partial + "'");
        result.append(text, at, open - at);
        result += withPartials(markTagLines(markVariables(*found)), templates, name, depth + 1);
        at = close + 2;
    }
    return result + text.substr(at);
}

std::string prepared(const std::string& text, const Templates& templates, const std::string& name) {
    return withPartials(markTagLines(markVariables(text)), templates, name);
}

std::string withoutTagLines(const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != kTagLine) {
            result += text[i];
        } else if (i + 1 < text.size() && text[i + 1] == '\n') {
            ++i;
        }
    }
    return result;
}

class Context : public mustache::context<std::string> {
public:
    Context(const mustache::data* root, std::string name)
        : mustache::context<std::string>(root), name_(std::move(name)) {}

    const mustache::data* get(const std::string& key) const override {
        const bool variable = !key.empty() && key.front() == kVariableMark;
        const std::string plain = variable ? key.substr(1) : key;
        const mustache::data* found = mustache::context<std::string>::get(plain);
        if (!variable) return found == nullptr || isEmptyString(*found) ? nullptr : found;
        if (found == nullptr) throw RenderError(name_ + ": no key '" + plain + "' in the view");
        if (found->is_false()) return &empty_;
        if (!found->is_string()) throw RenderError(name_ + ": key '" + plain + "' is not a string or number");
        return found;
    }

private:
    static bool isEmptyString(const mustache::data& value) { return value.is_string() && value.string_value().empty(); }

    std::string name_;
    mustache::data empty_{std::string()};
};

}  // namespace

Renderer::Renderer(Templates templates) : templates_(std::move(templates)) {}

std::string Renderer::render(const std::string& templateName, const nlohmann::json& view) const {
    const std::string* text = templates_.find(templateName);
    if (text == nullptr) throw RenderError("no template '" + templateName + "'");
    mustache::mustache engine(prepared(*text, templates_, templateName));
    if (!engine.is_valid()) throw RenderError(templateName + ": " + engine.error_message());
    const mustache::data data = toData(view);
    Context context(&data, templateName);
    std::string result = engine.render(context);
    if (!engine.is_valid()) throw RenderError(templateName + ": " + engine.error_message());
    return withoutTagLines(result);
}

}  // namespace oroforge::render
