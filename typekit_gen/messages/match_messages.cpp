// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <messages/match_messages.hpp>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include <messages/identity.hpp>
#include <messages/wire_match.hpp>
#include <model/shown_name.hpp>

namespace oroforge::messages {

namespace {

bool isTagName(const std::string& text) {
    const auto isPart = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    return !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0 &&
           std::all_of(text.begin(), text.end(), isPart);
}

std::string fieldOf(const std::string& path) { return path.substr(path.rfind('.') + 1); }
std::string placeOf(const std::string& path) { return path.substr(0, path.rfind('.') + 1); }

class Matcher {
public:
    Matcher(model::TypeModel& model, diag::Sink& sink) : model_(model), sink_(sink), set_(search_, sink) {}

    void run() {
        for (const model::Struct& type : model_.structs)
            if (!type.message.empty()) match(type);
        model_.files.insert(model_.files.end(), set_.files().begin(), set_.files().end());
    }

private:
    void match(const model::Struct& type) {
        std::istringstream words(type.message);
        std::string name, sum, more;
        words >> name >> sum >> more;
        const std::size_t slash = std::min(name.find('/'), name.size());
        if (!isTagName(name.substr(0, slash)) || slash == name.size() || !isTagName(name.substr(slash + 1)) ||
            !more.empty()) {
            sink_
                .error(type.where, "TK080",
                       "'@ros" + (name.empty() ? "" : " " + type.message) + "' of '" + shown(type) +
                           "' does not name a message")
                .hint("write '@ros geometry_msgs/Pose': the package and the name; the MD5 sum may follow");
            return;
        }
        if (!type.assignable || !type.make.empty()) {
            sink_
                .error(type.where, "TK080",
                       "'" + shown(type) + "' cannot be the message '" + name + "': its values cannot go over ports")
                .hint("give it a default constructor and no constant members");
            return;
        }
        const Message* const message = set_.message(name, type.where);
        if (message == nullptr) return;
        const std::string known = md5Of(*message, set_);
        if (!sum.empty() && sum != known)
            sink_
                .error(type.where, "TK082",
                       "'" + shown(type) + "' is to be '" + name + "' with the MD5 sum " + sum + ", but the one of " +
                           message->file + " is " + known)
                .hint("another version of the message is installed: compare the fields, then change the sum");
        else if (compare(type, *message))
            model_.messages.push_back({type.name, name, known, definitionOf(*message, set_)});
    }

    bool compare(const model::Struct& type, const Message& message) {
        const std::vector<Wire> own = wireOf(type, model_), its = wireOf(message, set_);
        Pairs pairs;
        const std::vector<Difference> differences = compareWires(own, its, pairs);
        for (const Difference& one : differences) {
            diag::Diagnostic& error =
                sink_.error(one.where.line == 0 ? type.where : one.where, "TK081",
                            "'" + shown(type) + "' is not '" + message.fullName() + "': " + one.message);
            if (one.there.line != 0) error.note(one.there, "this is the field of the message");
        }
        if (differences.empty()) compareNames(type, message, pairs);
        return differences.empty();
    }

    /// Equal types in another order have the same form, but mean something else.
    void compareNames(const model::Struct& type, const Message& message, const Pairs& pairs) {
        std::set<std::string> paths;
        for (const auto& [own, its] : pairs) paths.insert(its->path);
        for (const auto& [own, its] : pairs) {
            const std::string name = fieldOf(own->path);
            if (name == fieldOf(its->path) || paths.count(placeOf(its->path) + name) == 0) continue;
            sink_
                .warning(own->where, "TK083",
                         "field '" + own->path + "' of '" + shown(type) + "' is where '" + message.fullName() +
                             "' has '" + its->path + "'; its own '" + name + "' is elsewhere")
                .note(its->where, "this is the field of the message")
                .hint("put the fields in the order of the message, or give them other names");
            return;
        }
    }

    static std::string shown(const model::Struct& type) { return model::cppShown(type.cpp); }

    model::TypeModel& model_;
    diag::Sink& sink_;
    PackageSearch search_;
    MessageSet set_;
};

}  // namespace

void matchMessages(model::TypeModel& model, diag::Sink& sink) {
    const auto isMessage = [](const model::Struct& type) { return !type.message.empty(); };
    if (std::any_of(model.structs.begin(), model.structs.end(), isMessage)) Matcher(model, sink).run();
}

}  // namespace oroforge::messages
