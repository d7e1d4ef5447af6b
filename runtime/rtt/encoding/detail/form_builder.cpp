// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/encoding/detail/form_builder.hpp>

#include <rtt/encoding/detail/walk.hpp>
#include <rtt/types/ShownTable.hpp>
#include <rtt/types/StructTable.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/Types.hpp>
#include <rtt/types/VariantTable.hpp>

#include <boost/core/demangle.hpp>

#include <algorithm>
#include <cstring>
#include <map>
#include <typeinfo>
#include <utility>
#include <variant>
#include <vector>

namespace RTT::encoding::detail {

using types::Shape;

namespace {

std::uint8_t sizeOf(Shape::Number number) {
    switch (number) {
        case Shape::Number::Bool:
        case Shape::Number::Char:
        case Shape::Number::Int8:
        case Shape::Number::UInt8: return 1;
        case Shape::Number::Int16:
        case Shape::Number::UInt16: return 2;
        case Shape::Number::Int32:
        case Shape::Number::UInt32:
        case Shape::Number::Float32: return 4;
        default: return 8;
    }
}

/** The forms of one plan, each type once. */
class FormBuilder {
public:
    FormBuilder(const Rules& rules, ReadOnly readOnly)
        : rules_(rules), readOnly_(readOnly), forms_(std::make_shared<Forms>()) {}

    std::shared_ptr<const Form> build(const types::TypeInfo& type, std::string& why) {
        const Form* const root = formOf(type);
        why = why_;
        return root && why.empty() ? std::shared_ptr<const Form>(forms_, root) : nullptr;
    }

private:
    typedef std::map<std::string, std::unique_ptr<Form>> Forms;

    void fail(const std::string& reason) {
        if (!why_.empty()) return;
        for (const std::string& part : path_) why_ += part;
        why_ += (why_.empty() ? "" : ": ") + reason;
    }
    const Form* failed(const std::string& reason) {
        fail(reason);
        return nullptr;
    }

    /** `part` is how the containing type calls it: ".x", "[]". */
    const Form* formOf(const char* type, const std::string& part) {
        path_.push_back(part);
        const types::TypeInfo* const known = types::Types()->getTypeById(type);
        const Form* const form =
            known ? formOf(*known) : failed("no typekit that is loaded has the type " + boost::core::demangle(type));
        path_.pop_back();
        return form;
    }
    const Form* formOf(const types::TypeInfo& type) {
        const auto [entry, isNew] = forms_->emplace(type.getTypeIdName(), nullptr);
        if (!isNew) return entry->second.get();
        entry->second = std::make_unique<Form>();
        Form& form = *entry->second;
        form.shape = type.shape();
        if (!form.shape) return failed("the type " + type.getTypeName() + " has no shape: " + form.shape.reason);
        if (*type.getArrayElement() != '\0') return failed("the type " + type.getTypeName() + " is a view of an array");
        fill(form);
        return why_.empty() ? &form : nullptr;
    }

    void fill(Form& form) {
        switch (form.shape.kind) {
            case Shape::Kind::Number: return makeNumber(form, sizeOf(form.shape.number));
            case Shape::Kind::Enumeration: return makeEnumeration(form);
            case Shape::Kind::Text: form.least = rules_.textEndsWithZero ? 5 : 4; return;
            case Shape::Kind::Struct: return makeStruct(form);
            case Shape::Kind::Sequence: return makeSequence(form);
            case Shape::Kind::Variant: return makeVariant(form);
            case Shape::Kind::Shown: return makeShown(form);
            case Shape::Kind::None: return;
        }
    }

    void makeNumber(Form& form, std::size_t size) {
        form.numberSize = static_cast<std::uint8_t>(size);
        form.isSolid = form.hasFixedSize = true;
        form.hasBool = form.shape.kind == Shape::Kind::Number && form.shape.number == Shape::Number::Bool;
        form.align = rules_.alignmentOf(size);
        form.least = size;
    }
    void makeEnumeration(Form& form) {
        if (!rules_.enumsByRank || form.shape.enumerators.empty()) {
            makeNumber(form, form.size());
            form.hasBool = isOfBool(form);
            return;
        }
        std::vector<Shape::Enumerator> all = form.shape.enumerators;
        std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
        for (const Shape::Enumerator& one : all) form.byRank.push_back(one.value);
        form.numberSize = 4;
        form.align = rules_.alignmentOf(4);
        form.least = 4;
        form.hasFixedSize = true;
    }

    /** The type that the enumeration is based on is bool. */
    static bool isOfBool(const Form& form) {
        if (form.size() != 1 || !form.shape.ops->construct) return false;
        const Temporary value(*form.shape.ops);
        form.shape.numbers->set(value.at(), 2);
        return form.shape.numbers->get(value.at()) == 1;
    }

    // `least` stays 1 until it is known, because the type may contain itself.
    void makeStruct(Form& form) {
        std::size_t least = 0;
        bool hasFixedSize = true;
        for (const Shape::Field& field : form.shape.fields) {
            FormField its{field.name, nullptr, field.offset, field.count, field.access, field.doc, field.unit};
            if (readOnly_ == ReadOnly::LeftOut && its.isReadOnly()) continue;
            its.form = formOf(field.type, "." + field.name);
            if (!its.form) return;
            if (its.access && !hasTemporary(*its.form, "." + field.name)) return;
            form.fields.push_back(its);
            if (its.isReadOnly()) continue;
            least += its.form->least * (its.count ? its.count : 1);
            hasFixedSize = hasFixedSize && its.form->hasFixedSize;
        }
        layOut(form, rules_);
        form.least = form.steps.empty() && rules_.emptyStructHasByte ? 1 : least;
        form.hasFixedSize = hasFixedSize;
    }
    void makeSequence(Form& form) {
        const types::SequenceOps& ops = *form.shape.elements;
        form.element = formOf(ops.elementType(), "[]");
        if (!form.element) return;
        if (!ops.at && !hasTemporary(*form.element, "[]")) return;
        form.least = 4;
        if (ops.resize) {
            const Shape& element = form.element->shape;
            form.hasRows = !ops.at && !ops.insert && element.kind == Shape::Kind::Sequence && element.elements->resize;
            if (form.element->least == 0) fail("its elements have no bytes");
            return;
        }
        if (!form.shape.ops->construct) return fail("its size is fixed, and there is no default value that shows it");
        const Temporary value(*form.shape.ops);
        form.fixedCount = ops.size(value.at());
        form.least = form.fixedCount * form.element->least;
        form.hasFixedSize = form.element->hasFixedSize;
    }
    void makeVariant(Form& form) {
        for (const Shape::Field& field : form.shape.fields) {
            const bool hasValue = std::strcmp(field.type, typeid(std::monostate).name()) != 0;
            const Form* const its = hasValue ? formOf(field.type, "." + field.name) : nullptr;
            if (hasValue && !its) return;
            form.fields.push_back({field.name, its, 0, 0, nullptr});
        }
        form.least = 4;
    }
    void makeShown(Form& form) {
        form.shown = formOf(form.shape.shown->type(), "");
        if (!form.shown || !hasTemporary(*form.shown, "")) return;
        form.least = form.shown->least;
        form.hasFixedSize = form.shown->hasFixedSize;
    }
    bool hasTemporary(const Form& form, const std::string& part) {
        if (form.shape.ops->construct) return true;
        path_.push_back(part);
        fail("its type has no default value");
        path_.pop_back();
        return false;
    }

    const Rules rules_;
    const ReadOnly readOnly_;
    const std::shared_ptr<Forms> forms_;
    std::vector<std::string> path_;
    std::string why_;
};

}  // namespace

std::shared_ptr<const Form> buildForm(const types::TypeInfo& type, const Rules& rules, ReadOnly readOnly,
                                      std::string& why) {
    return FormBuilder(rules, readOnly).build(type, why);
}

}  // namespace RTT::encoding::detail
