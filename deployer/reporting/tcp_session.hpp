// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_TCP_SESSION_HPP
#define ORO_OCL_REPORTING_TCP_SESSION_HPP

#include "frame_text.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace OCL::reporting {

/** What one client may use. */
struct TcpLimits {
    std::size_t line = 100;         ///< characters of a command
    std::size_t backlog = 4 << 20;  ///< bytes that wait for the client; one frame may be larger
};

/**
 * The conversation with one client of TcpReporting: bytes that it sent become replies, rows become frames. Both wait in
 * backlog() until they are sent. Used by one thread at a time; knows nothing of sockets.
 */
class TcpSession {
public:
    /** Begins with the greeting. `names` must outlive this. */
    TcpSession(const std::vector<std::string>& names, const TcpLimits& limits);

    /** Takes bytes from the client. They are only kept, not executed, while full(). */
    void receive(std::string_view bytes);
    /** Appends the frame of a row if the client wants one. False if it found no room, and is dropped. */
    bool addFrame(const FrameText& row);

    std::string_view backlog() const { return std::string_view(out_).substr(sent_); }
    /** Removes the first bytes of the backlog, and executes commands that waited for room. */
    void sent(std::size_t bytes);
    /** The backlog has reached its limit: nothing should be received now. */
    bool full() const { return backlog().size() >= limits_.backlog; }

    bool wantsFrames() const { return greeted_ && !silenced_ && !subscribed_.empty() && !ended_; }
    /** The client has sent VERSION. */
    bool greeted() const { return greeted_; }
    /** The client has sent QUIT, or end() was called: nothing more is executed or added. */
    bool ended() const { return ended_; }
    void end() { ended_ = true; }

private:
    struct Command {
        const char* name;
        const char* syntax;
        /** Executes it; false for a syntax error. */
        bool (TcpSession::*run)(std::string_view arguments);
        enum When { Always, Before, After } when;  ///< VERSION
    };
    static const Command kCommands[];

    void executeLines();
    bool appendFrame(const FrameText& row, const std::string& number);
    void execute(std::string_view line);
    const Command* find(std::string_view name) const;
    void reply(std::string_view code, std::string_view rest = {});
    /** The index of the name in names_, or its size. */
    std::size_t indexOf(std::string_view name) const;

    bool version(std::string_view arguments);
    bool help(std::string_view arguments);
    bool quit(std::string_view arguments);
    bool listExtensions(std::string_view arguments);
    bool headers(std::string_view arguments);
    bool subscribe(std::string_view arguments);
    bool unsubscribe(std::string_view arguments);
    bool subs(std::string_view arguments);
    bool silence(std::string_view arguments);
    bool setLimit(std::string_view arguments);

    const std::vector<std::string>& names_;
    const TcpLimits limits_;
    std::string in_;        // what is not executed yet
    bool tooLong_ = false;  // the line that in_ continues has been dropped
    std::string out_;       // backlog() after the first sent_ bytes
    std::size_t sent_ = 0;
    bool greeted_ = false, silenced_ = false, ended_ = false;
    std::vector<std::size_t> subscribed_;
    std::uint64_t frame_ = 0;  // the number of the next frame
    std::uint64_t limit_ = 0;  // the last frame to send; 0: no limit
    bool limitTold_ = false;
};

}  // namespace OCL::reporting

#endif
