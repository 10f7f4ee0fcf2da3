#pragma once
// Configures GDAL so that the contents of a file open neither a connection nor another file.

namespace tramline::io {

/// To be called before GDAL opens anything. From then on, in the whole process, GDAL fetches nothing
/// (schemas, coordinate reference systems, styles, remote files), resolves no links or entities of GML, loads
/// no extension of SQLite that reads other files, and PROJ uses no network. Only the first call does
/// anything; safe for several threads.
void start_gdal();

/// While one exists, GDAL may open connections: for an address that the user has typed, such as
/// "WFS:https://…" or "/vsicurl/https://…", not for the contents of a file. It applies to the whole process,
/// so only a program that does not serve others may create one. Precondition: start_gdal() was called.
class ConnectionsAllowed {
 public:
  ConnectionsAllowed();
  ConnectionsAllowed(const ConnectionsAllowed&) = delete;
  ConnectionsAllowed& operator=(const ConnectionsAllowed&) = delete;
  ~ConnectionsAllowed();
};

}  // namespace tramline::io
