// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/service/typed_text.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/base/AttributeBase.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <rtt/scripting/check.hpp>

namespace RTT::scripting::detail {

TypedText::TypedText(TaskContext& component, std::shared_ptr<SourceFile> file, Scope& scope)
    : ScriptReader(component, std::move(file)), gate_(component.engine()->gate()), scope_(scope) {}

TypedText::~TypedText() = default;

bool TypedText::run(TypedInput::Answer& answer, std::ostream& out) {
    out_ = &out;
    if (!parse()) return false;
    for (const ast::Item& item : file_->tree.items) {
        answer_ = {};
        if (gate_->closed()) {
            error(item.at, "OPS415", "an earlier statement has destroyed the component");
            return false;
        }
        if (!take(item)) return false;
    }
    answer = answer_;
    return true;
}

void TypedText::answer(const Source& value) {
    answer_.kind = value ? TypedInput::Answer::Value : TypedInput::Answer::Void;
    answer_.value = value;
}

bool TypedText::take(const ast::Item&, const ast::StatementPtr& statement) {
    if (const auto* const todo = std::get_if<ast::Do>(&statement->what)) return evaluate(*todo->expression);
    if (const auto* const declaration = std::get_if<ast::Declaration>(&statement->what))
        return declare(*statement, *declaration);
    const std::unique_ptr<Code> code = compiler_.statement(*statement, scope_);
    return code && execute(*code);
}

bool TypedText::evaluate(const ast::Expression& expression) {
    Source value;
    Compiler compiler(context(internal::GlobalEngine::Instance()));
    const std::unique_ptr<Code> code = compiler.value(expression, scope_, value);
    if (!code || !execute(*code)) return false;
    answer(value);
    return true;
}

bool TypedText::isFree(const ast::Identifier& name) {
    const Service& component = *component_.provides();
    if (scope_.findHere(name.text) || !(component.hasAttribute(name.text) || component.hasProperty(name.text)))
        return true;
    error(name.at, "OPS111",
          "'" + name.text + "' is " + (component.hasProperty(name.text) ? "a property" : "an attribute") +
              " of component '" + component_.getName() + "' already; assign to it, or take another name");
    return false;
}

bool TypedText::declare(const ast::Statement& statement, const ast::Declaration& declaration) {
    for (const ast::Declarator& declarator : declaration.names)
        if (!isFree(declarator.name)) return false;
    const std::unique_ptr<Code> code = compiler_.statement(statement, scope_);
    for (const ast::Declarator& declarator : declaration.names) {
        const Scope::Entry* const entry = scope_.findHere(declarator.name.text);
        has_aliases_ = has_aliases_ || (entry && entry->alias);
    }
    if (!code || !execute(*code)) return false;
    for (const ast::Declarator& declarator : declaration.names) publish(declarator);
    return true;
}

/** Makes a declared variable an attribute of the component. */
void TypedText::publish(const ast::Declarator& declarator) {
    const Scope::Entry* const entry = scope_.findHere(declarator.name.text);
    if (!entry || !entry->source || gate_->closed()) return;
    const types::TypeInfo& type = *entry->source->getTypeInfo();
    const std::string& name = declarator.name.text;
    std::unique_ptr<base::AttributeBase> made(entry->constant ? type.buildConstant(name, entry->source)
                                                              : type.buildAttribute(name, entry->source));
    if (made) component_.provides()->setValue(made.release());
    const Source copy = type.buildValue();
    if (copy && copy->update(entry->source.get())) answer(copy);
}

/** Passes the item alone to the service, with its place in the whole text. */
bool TypedText::define(const ast::Item& item) {
    std::string text = file_->text.substr(0, item.begin + item.size);
    for (std::size_t i = 0; i != item.begin; ++i)
        if (text[i] != '\n') text[i] = ' ';
    if (!component_.loadService("scripting")) {
        error(item.at, "OPS416",
              "component '" + component_.getName() + "' has no service 'scripting' that would keep this");
        return false;
    }
    const auto service = boost::dynamic_pointer_cast<ScriptingService>(component_.provides()->getService("scripting"));
    if (!service) {
        error(item.at, "OPS416",
              "the service 'scripting' of component '" + component_.getName() + "' belongs to another process");
        return false;
    }
    // After the check little can fail, and the log reports that.
    return checkScriptText(text, file_->name, component_, *out_) && service->evalInternal(file_->name, text);
}

}  // namespace RTT::scripting::detail
