# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""A back-end of omniidl, which writes what of an IDL file other programs see: repository ids, members and signatures.

omniidl -p FOLDER -bidl_contract FILE.idl
"""
from omniidl import idlast, idltype

NAMES = {
    idltype.tk_void: "void", idltype.tk_boolean: "boolean", idltype.tk_any: "any", idltype.tk_long: "long",
    idltype.tk_ushort: "unsigned short", idltype.tk_string: "string",
}


def type_name(type):
    if isinstance(type, idltype.Sequence):
        bound = ", %d" % type.bound() if type.bound() else ""
        return "sequence<%s%s>" % (type_name(type.seqType()), bound)
    if isinstance(type, idltype.String) and type.bound():
        return "string<%d>" % type.bound()
    if isinstance(type, idltype.Declared):
        # What all files have in common says nothing.
        return "::".join(type.scopedName()).replace("RTT::corba::", "", 1)
    return NAMES.get(type.kind(), "kind %d" % type.kind())


def declarator_name(declarator):
    return declarator.identifier() + "".join("[%d]" % size for size in declarator.sizes())


def members_of(node):
    return "; ".join("%s %s" % (type_name(member.memberType()), declarator_name(one))
                     for member in node.members() for one in member.declarators())


def signature_of(operation):
    parameters = ", ".join("%s %s %s" % (one.dirtext(), type_name(one.paramType()), one.identifier())
                           for one in operation.parameters())
    raised = ", ".join(one.repoId() for one in operation.raises())
    return "%s%s %s(%s)%s" % ("oneway " if operation.oneway() else "", type_name(operation.returnType()),
                              operation.identifier(), parameters, " raises " + raised if raised else "")


def show_interface(node):
    bases = ", ".join(one.repoId() for one in node.inherits())
    print("interface %s%s" % (node.repoId(), ": " + bases if bases else ""))
    for one in node.callables():
        print("    " + (signature_of(one) if isinstance(one, idlast.Operation) else str(one)))
    show(one for one in node.contents() if not isinstance(one, idlast.Operation))


def show(declarations):
    for node in declarations:
        if not node.mainFile() or isinstance(node, (idlast.Forward, idlast.StructForward)):
            continue
        if isinstance(node, idlast.Module):
            show(node.definitions())
        elif isinstance(node, idlast.Interface):
            show_interface(node)
        elif isinstance(node, idlast.Enum):
            print("enum %s = %s" % (node.repoId(), ", ".join(one.identifier() for one in node.enumerators())))
        elif isinstance(node, idlast.Struct):
            print("struct %s = %s" % (node.repoId(), members_of(node)))
        elif isinstance(node, idlast.Exception):
            print(("exception %s = %s" % (node.repoId(), members_of(node))).rstrip())
        elif isinstance(node, idlast.Typedef):
            for one in node.declarators():
                print("typedef %s = %s" % (one.repoId(), type_name(node.aliasType())))
        else:
            print("unexpected %s" % node)


def run(tree, args):
    show(tree.declarations())
