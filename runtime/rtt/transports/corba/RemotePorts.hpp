// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_REMOTE_PORTS_HPP
#define ORO_CORBA_REMOTE_PORTS_HPP

#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/transports/corba/DataFlowC.h>

#include <memory>
#include <mutex>
#include <string>

namespace RTT {
namespace types {
class TypeInfo;
}
namespace corba {
namespace detail {
class LostConnections;
}

/** What stands for a port of another process: it can be connected, but neither written nor read. Its functions call the
    other process, block for three seconds at most, and return false, with an error logged, if it does not answer. */
template <class Base>
class RTT_API RemotePort : public Base {
public:
    RemotePort(const types::TypeInfo* type, CDataFlowInterface_ptr interface, const std::string& name);
    ~RemotePort() override;

    /** From now on it stands for the port of that name there, as after the other process has started again. Nil: it
        calls nobody any more. */
    void attach(CDataFlowInterface_ptr interface);
    /** The caller owns the reference; nil if there is none. */
    CDataFlowInterface_ptr getDataFlowInterface() const;
    /** The other process does not answer: until restore() it is not called. */
    void lost();
    /** It answers again: connects again with the ports of this process that it was connected with. */
    void restore();
    const types::TypeInfo* getTypeInfo() const override { return type_; }
    int serverProtocol() const override;
    bool connected() const override;
    bool connectedTo(base::PortInterface* port) const override;
    using base::PortInterface::disconnect;
    void disconnect() override;
    bool disconnect(base::PortInterface* port) override;
    bool createStream(ConnPolicy const& policy) override;

protected:
    /** Calls the other process; `otherwise` if it does not answer, with an error logged. */
    template <class Result, class Call>
    Result ask(const char* wanted, Result otherwise, Call call) const;
    const std::shared_ptr<detail::LostConnections> lost_;

private:
    mutable std::mutex mutex_;
    CDataFlowInterface_var interface_;
    bool isLost_ = false;
    const types::TypeInfo* const type_;
};

class RTT_API RemoteInputPort : public RemotePort<base::InputPortInterface> {
public:
    RemoteInputPort(const types::TypeInfo* type, CDataFlowInterface_ptr interface, const std::string& name)
        : RemotePort(type, interface, name) {}

    bool connectFrom(base::OutputPortInterface& output, ConnPolicy const& policy) override;
    base::DataSourceBase* getDataSource() override;
    base::PortInterface* clone() const override;
    base::PortInterface* antiClone() const override;
};

class RTT_API RemoteOutputPort : public RemotePort<base::OutputPortInterface> {
public:
    RemoteOutputPort(const types::TypeInfo* type, CDataFlowInterface_ptr interface, const std::string& name)
        : RemotePort(type, interface, name) {}

    using base::OutputPortInterface::createConnection;
    bool createConnection(base::InputPortInterface& sink, ConnPolicy const& policy) override;
    base::DataSourceBase* getDataSource() const override;
    base::PortInterface* clone() const override;
    base::PortInterface* antiClone() const override;
};

}  // namespace corba
}  // namespace RTT

#endif
