// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The steps of a struct: neighbouring numbers become one copy.
#include <rtt/encoding/detail/form_builder.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace RTT::encoding::detail {

namespace {

/** A struct that is repeated in an array is taken apart only up to this many numbers. */
constexpr std::size_t kMostNumbers = 64;

class Layout {
public:
    Layout(Form& form, const Rules& rules) : form_(form), rules_(rules) {}

    void run() {
        for (const FormField& field : form_.fields) {
            if (!field.isReadOnly() && !addNumbers(field)) addField(field);
        }
        finish();
        if (form_.steps.size() != 1 || form_.steps[0].field) return;
        const FormStep& only = form_.steps[0];
        form_.isSolid = only.offset == 0 && only.bytes == form_.size() && only.bytes % only.align == 0;
        form_.hasBool = only.hasBool;
        if (form_.isSolid) form_.align = only.align;
    }

private:
    /** False if the field is more than some numbers. */
    bool addNumbers(const FormField& field) {
        const Form& form = *field.form;
        if (field.access) return false;
        const std::size_t count = field.count ? field.count : 1;
        if (form.numberSize != 0) {
            if (!form.isSolid) return false;
            add({field.offset, count, form.numberSize, form.hasBool});
            return true;
        }
        const bool isOnlyNumbers = !form.steps.empty() && std::all_of(form.steps.begin(), form.steps.end(),
                                                                      [](const FormStep& step) { return !step.field; });
        std::size_t all = 0;
        for (const FormStep& step : form.steps) all += step.numbers.size();
        if (!isOnlyNumbers || all * count > kMostNumbers) return false;
        for (std::size_t i = 0; i != count; ++i)
            for (const FormStep& step : form.steps)
                for (FormNumbers numbers : step.numbers) {
                    numbers.offset += field.offset + i * form.size();
                    add(numbers);
                }
        return true;
    }
    void addField(const FormField& field) {
        finish();
        form_.steps.emplace_back();
        form_.steps.back().field = &field;
    }
    void add(const FormNumbers& numbers) {
        if (!follow(numbers)) {
            finish();
            open_.offset = numbers.offset;
            isOpen_ = true;
        }
        open_.bytes = numbers.offset + numbers.count * numbers.size - open_.offset;
        open_.align = std::max(open_.align, rules_.alignmentOf(numbers.size));
        open_.hasBool = open_.hasBool || numbers.isBool;
        FormNumbers* const last = open_.numbers.empty() ? nullptr : &open_.numbers.back();
        if (last && last->size == numbers.size && last->isBool == numbers.isBool)
            last->count += numbers.count;
        else
            open_.numbers.push_back(numbers);
    }
    /** They continue the open step: no gap before them, neither in memory nor in the encoding. */
    bool follow(const FormNumbers& numbers) const {
        return isOpen_ && numbers.offset == open_.offset + open_.bytes &&
               open_.bytes % rules_.alignmentOf(numbers.size) == 0;
    }
    void finish() {
        if (isOpen_) form_.steps.push_back(std::move(open_));
        open_ = FormStep();
        isOpen_ = false;
    }

    Form& form_;
    const Rules& rules_;
    FormStep open_;
    bool isOpen_ = false;
};

}  // namespace

void layOut(Form& form, const Rules& rules) { Layout(form, rules).run(); }

}  // namespace RTT::encoding::detail
