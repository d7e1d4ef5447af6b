#pragma once
#include <rtt/RTT.hpp>

namespace tank
{
class Plant : public RTT::TaskContext
{
  public:
    explicit Plant( const std::string& name );   // spaces of the user
    void drain();

  protected:
    void updateHook() override;

  private:
    double  gain{ 1.0 };
};
} // namespace tank
