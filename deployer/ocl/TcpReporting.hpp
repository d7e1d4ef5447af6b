// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_TCP_REPORTING_HPP
#define ORO_OCL_TCP_REPORTING_HPP

#include <ocl/ReportingComponent.hpp>

#include <memory>
#include <string>

namespace OCL {

namespace reporting {
struct TcpCounts;
}

/**
 * Reports to programs that connect by TCP and subscribe to names, from start() to stop(). The protocol is one of lines
 * (see docs/components.md).
 *
 * It listens on the address 127.0.0.1 unless told otherwise: the protocol has neither passwords nor encryption. A row
 * costs the component what it costs other reporters. Two threads of ordinary priority make text and serve clients.
 * Their sockets never block, so a client that reads slowly loses frames itself and delays nothing.
 *
 * start() reads the properties. stop() sends the rows that still wait in the buffer, for two seconds at most, and gives
 * clients 0.2 s to take them. The attributes are updated with each row: `used_port`, the port it listens on, or 0;
 * `clients`, which are connected; `refused_clients` and `dropped_frames`, since start().
 */
class OCL_API TcpReporting : public ReportingComponent {
public:
    explicit TcpReporting(const std::string& name = "TcpReporting");
    ~TcpReporting() override;

    /** Writes to the standard error output. */
    bool screenComponent(const std::string& component) override;

protected:
    /** Unlike other reporters, accepts an empty ReportData: the operations may select what is reported. */
    bool configureHook() override;
    /** Listens. False, and an error in the log, if the port and the four after it are in use. */
    bool startHook() override;
    void updateHook() override;
    void stopHook() override;

private:
    bool hasGoodLimits() const;
    void updateCounts();

    std::string address_ = "127.0.0.1";
    unsigned int port_ = 3142;
    unsigned int maxClients_ = 32;
    unsigned int maxLine_ = 100;
    unsigned int maxBacklog_ = 4 << 20;
    unsigned int usedPort_ = 0, clients_ = 0, refused_ = 0, dropped_ = 0;
    std::shared_ptr<const reporting::TcpCounts> counts_;
};

}  // namespace OCL

#endif
