int lowerSupport() { return 21; }
