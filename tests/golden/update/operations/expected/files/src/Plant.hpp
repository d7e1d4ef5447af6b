#pragma once
#include <tank/PlantBase.hpp>

namespace tank { namespace models {

class Plant : public PlantBase
{
  public:
    explicit Plant( const std::string& name );

    /** Fills it. */
    virtual bool fill( double rate, double amount = 1.0 /* litres */ );   ///< mine
                                                            ///< and this
    virtual void old() { }
    int fill( int ) { return 0; } // an overload

    /**
     * The level
     * Measured now.
     */
    virtual double sample();

    virtual void drain( std::string amount );

  protected:
#ifdef TRACE
    virtual void trace();
#endif
    virtual void updateHook();
    virtual bool startHook();
    virtual void stopHook();
};

} }
