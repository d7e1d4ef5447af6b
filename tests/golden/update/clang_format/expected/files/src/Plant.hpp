#pragma once
#include <rtt/RTT.hpp>

namespace tank
{
class Plant : public RTT::TaskContext
{
  public:
    explicit Plant( const std::string& name );   // spaces of the user

    /// Fills it up to a level, however long that takes,
    /// unless it is stopped.
    bool fill(double level, const std::string& tolerance);
    void drain();

  protected:
    void updateHook() override;
    bool startHook() override;

  private:
    double  gain{ 1.0 };
    RTT::OutputPort<double>
        level_; ///< How high the water stands in the tank
};
} // namespace tank
