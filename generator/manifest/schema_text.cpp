// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <manifest/schema.hpp>

#include <sstream>

namespace oroforge::manifest {

namespace {

void writeType(std::ostream& out, const AttributeRule& rule) {
    const char* type = "xs:string";
    switch (rule.kind) {
        case ValueKind::Number: type = "xs:double"; break;
        case ValueKind::Integer: type = "xs:integer"; break;
        case ValueKind::Boolean: type = "truth"; break;
        case ValueKind::Choice:
        case ValueKind::Text: break;
    }
    out << "      <xs:attribute name=\"" << rule.name << '"';
    if (rule.required) out << " use=\"required\"";
    if (rule.kind != ValueKind::Choice) {
        out << " type=\"" << type << "\"/>\n";
        return;
    }
    out << ">\n        <xs:simpleType>\n          <xs:restriction base=\"xs:string\">\n";
    for (const std::string& choice : rule.choices) out << "            <xs:enumeration value=\"" << choice << "\"/>\n";
    out << "          </xs:restriction>\n        </xs:simpleType>\n      </xs:attribute>\n";
}

void writeElement(std::ostream& out, const ElementRule& rule) {
    out << "\n  <xs:element name=\"" << rule.name << "\"";
    if (rule.hasText) {
        out << " type=\"xs:string\"/>\n";
        return;
    }
    out << ">\n    <xs:complexType>\n";
    if (!rule.children.empty()) {
        out << "      <xs:choice minOccurs=\"0\" maxOccurs=\"unbounded\">\n";
        for (const ChildRule& child : rule.children) out << "        <xs:element ref=\"" << child.name << "\"/>\n";
        out << "      </xs:choice>\n";
    }
    for (const AttributeRule& attribute : rule.attributes) writeType(out, attribute);
    out << "    </xs:complexType>\n  </xs:element>\n";
}

}  // namespace

std::string schemaText() {
    std::ostringstream out;
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<!-- Component manifests of orocreate-pkg, for editors. Written by orocreate-pkg (schema_text.cpp) from "
           "the\n"
           "     rules that it checks itself; those also know what may be there only once, and what fits what. -->\n"
           "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\">\n"
           "  <xs:simpleType name=\"truth\">\n"
           "    <xs:restriction base=\"xs:string\">\n"
           "      <xs:enumeration value=\"true\"/>\n"
           "      <xs:enumeration value=\"false\"/>\n"
           "    </xs:restriction>\n"
           "  </xs:simpleType>\n";
    for (const ElementRule& rule : allRules()) writeElement(out, rule);
    out << "</xs:schema>\n";
    return out.str();
}

}  // namespace oroforge::manifest
