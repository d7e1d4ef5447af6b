// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "settings.hpp"

#include <rtt/Property.hpp>

#include <cmath>
#include <cstdlib>

namespace OCL::chain {
namespace {

constexpr unsigned long kMost = 1000000000;

/** Reads digits only; false if there are none, or the number is too large. */
bool number(const std::string& text, unsigned& result) {
    if (text.empty() || text.size() > 10 || text.find_first_not_of("0123456789") != std::string::npos) return false;
    const unsigned long value = std::strtoul(text.c_str(), nullptr, 10);
    result = static_cast<unsigned>(value);
    return value <= kMost;
}

/** Reads "2" or "2+1". */
bool readDivider(const std::string& text, Divider& result) {
    const std::size_t plus = text.find('+');
    if (!number(text.substr(0, plus), result.every) || result.every == 0) return false;
    if (plus == std::string::npos) return true;
    return number(text.substr(plus + 1), result.phase) && result.phase < result.every;
}

class Reading {
public:
    Reading(Settings& settings, std::vector<std::string>& findings) : settings_(settings), findings_(findings) {}

    void divider(const std::string& member, const std::string& text) {
        Divider value;
        if (!readDivider(text, value))
            findings_.push_back("divider '" + text + "' of '" + member +
                                "' is not a number of cycles, with a smaller phase after a plus; write 2 or 2+1");
        else if (!settings_.dividers.emplace(member, value).second)
            findings_.push_back("'" + member + "' has two dividers; leave one out");
    }

    void dividers(const std::vector<std::string>& texts) {
        for (const std::string& text : texts) {
            const std::size_t colon = text.rfind(':');
            if (colon == std::string::npos)
                findings_.push_back("divider '" + text + "' names no member; write it as \"a:2\" or \"a:2+1\"");
            else
                divider(text.substr(0, colon), text.substr(colon + 1));
        }
    }

    void dividers(const RTT::PropertyBag& bag) {
        for (const RTT::base::PropertyBase* entry : bag.getProperties()) {
            if (const auto* text = dynamic_cast<const RTT::Property<std::string>*>(entry))
                divider(text->getName(), text->rvalue());
            else if (const auto* count = dynamic_cast<const RTT::Property<int>*>(entry))
                divider(count->getName(), std::to_string(count->rvalue()));
            else if (const auto* unsignedCount = dynamic_cast<const RTT::Property<unsigned>*>(entry))
                divider(unsignedCount->getName(), std::to_string(unsignedCount->rvalue()));
            else
                findings_.push_back("divider of '" + entry->getName() + "' is a " + entry->getType() +
                                    "; write an int, or a string such as 2+1");
        }
    }

    std::int64_t budget(const std::string& of, double seconds) {
        if (seconds >= 0 && seconds < 1e9) return std::llround(seconds * 1e9);
        findings_.push_back("the budget of " + of + " is " + std::to_string(seconds) +
                            "; write seconds from 0, which means none");
        return 0;
    }

    void budgets(const RTT::PropertyBag& bag) {
        for (const RTT::base::PropertyBase* entry : bag.getProperties()) {
            const auto* const value = dynamic_cast<const RTT::Property<double>*>(entry);
            if (value)
                settings_.budgets[value->getName()] = budget("'" + value->getName() + "'", value->rvalue());
            else
                findings_.push_back("the budget of '" + entry->getName() + "' is a " + entry->getType() +
                                    "; write a double, in seconds");
        }
    }

    template <class Value>
    Value word(const char* property, const std::string& text, const std::vector<std::pair<const char*, Value>>& known) {
        std::string all;
        for (const auto& [name, value] : known) {
            if (text == name) return value;
            all += (all.empty() ? "" : ", ") + std::string(name);
        }
        findings_.push_back(std::string("property ") + property + " is '" + text + "'; write one of " + all);
        return known.front().second;
    }

private:
    Settings& settings_;
    std::vector<std::string>& findings_;
};

}  // namespace

Settings Settings::from(const Properties& properties, std::vector<std::string>& findings) {
    Settings result;
    Reading reading(result, findings);
    result.onError =
        reading.word<OnError>("on_error", properties.on_error,
                              {{"skip", OnError::Skip}, {"stop_cycle", OnError::StopCycle}, {"stop", OnError::Stop}});
    result.inOrder = reading.word<bool>("events", properties.events, {{"in_order", true}, {"at_once", false}});
    reading.dividers(properties.divider);
    reading.dividers(properties.dividers);
    result.budget = reading.budget("a cycle", properties.budget);
    reading.budgets(properties.budgets);
    result.stopOnOverrun = properties.stop_on_overrun;
    if (properties.report_every < 0)
        findings.push_back("property report_every is " + std::to_string(properties.report_every) +
                           "; write a number of cycles, or 0 for no reports");
    else
        result.reportEvery = static_cast<unsigned>(properties.report_every);
    return result;
}

}  // namespace OCL::chain
