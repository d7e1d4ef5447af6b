// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/naming.hpp>

#include <rtt/transports/corba/ApplicationServer.hpp>
#include <rtt/transports/corba/detail/remote_peer.hpp>
#include <rtt/transports/corba/detail/remote_reference.hpp>

#include <omniORB4/Naming.hh>

namespace RTT::corba::detail {

namespace {

/** Nil, with the reason in `why`, if there is none. */
CosNaming::NamingContext_var rootContext(std::string& why) {
    try {
        const CORBA::Object_var object = ApplicationServer::orb->resolve_initial_references("NameService");
        const CORBA::Object_var own = limitedObject(object);
        const CosNaming::NamingContext_var found = CosNaming::NamingContext::_narrow(own);
        why = CORBA::is_nil(found) ? "what -ORBInitRef names is no naming service" : "";
        return limited<CosNaming::NamingContext>(found);
    } catch (const CORBA::NO_RESOURCES&) {
        why = "its place is not given, as by -ORBInitRef NameService=corbaloc::localhost/NameService";
    } catch (const CORBA::ORB::InvalidName&) {
        why = "its place is not given, as by -ORBInitRef NameService=corbaloc::localhost/NameService";
    } catch (const CORBA::TRANSIENT&) {
        why = "it cannot be reached; omniNames starts one";
    } catch (const CORBA::TIMEOUT&) {
        why = "it does not answer";
    } catch (const CORBA::Exception& error) {
        why = describe(error);
    }
    return CosNaming::NamingContext::_nil();
}

CosNaming::Name pathOf(const char* name) {
    CosNaming::Name path;
    path.length(name ? 2 : 1);
    path[0].id = "TaskContexts";
    if (name) path[1].id = name;
    return path;
}

void makeContext(CosNaming::NamingContext_ptr root) {
    try {
        const CosNaming::NamingContext_var made = root->bind_new_context(pathOf(nullptr));
    } catch (const CosNaming::NamingContext::AlreadyBound&) {
        // Somebody else has made it.
    }
}

}  // namespace

Bound bindName(const std::string& name, CTaskContext_ptr component, std::string& why) {
    const CosNaming::NamingContext_var root = rootContext(why);
    if (CORBA::is_nil(root)) return Bound::NoService;
    try {
        makeContext(root);
        try {
            root->bind(pathOf(name.c_str()), component);
            return Bound::New;
        } catch (const CosNaming::NamingContext::AlreadyBound&) {
            const CORBA::Object_var present = root->resolve(pathOf(name.c_str()));
            if (component->_is_equivalent(present)) return Bound::New;
            root->rebind(pathOf(name.c_str()), component);
            return Bound::Again;
        }
    } catch (const CORBA::Exception& error) {
        why = describe(error);
        return Bound::Failed;
    }
}

void unbindName(const std::string& name, CTaskContext_ptr component) {
    try {
        std::string why;
        const CosNaming::NamingContext_var root = rootContext(why);
        if (CORBA::is_nil(root)) return;
        const CORBA::Object_var bound = root->resolve(pathOf(name.c_str()));
        if (component->_is_equivalent(bound)) root->unbind(pathOf(name.c_str()));
    } catch (const CORBA::Exception&) {
        // The naming service, or the name, is gone.
    }
}

CTaskContext_ptr resolveName(const std::string& name, std::string& why) {
    try {
        const CosNaming::NamingContext_var root = rootContext(why);
        if (CORBA::is_nil(root)) {
            why = "no naming service: " + why;
            return CTaskContext::_nil();
        }
        const CORBA::Object_var object = root->resolve(pathOf(name.c_str()));
        return CTaskContext::_narrow(object);
    } catch (const CosNaming::NamingContext::NotFound&) {
        why = "the naming service has no component of that name";
    } catch (const CORBA::Exception& error) {
        why = describe(error);
    }
    return CTaskContext::_nil();
}

}  // namespace RTT::corba::detail
