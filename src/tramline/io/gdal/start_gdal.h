#pragma once
// How GDAL is set up: what a file says opens neither a connection nor another file.

namespace tramline::io {

/// To be called before GDAL opens anything. From then on, in the whole process, GDAL fetches nothing
/// (schemas, coordinate reference systems, styles, remote files), resolves no links or entities of GML, loads
/// no extension of SQLite that reads other files, and PROJ uses no network. Only the first call does
/// anything; safe for several threads.
void start_gdal();

/// While one lives, GDAL may open connections: for an address that the user has typed, such as
/// "WFS:https://…" or "/vsicurl/https://…", and not for what stands in a file. For the whole process, so that
/// only a program that serves nobody else makes one. Precondition: start_gdal() was called.
class ConnectionsAllowed {
 public:
  ConnectionsAllowed();
  ConnectionsAllowed(const ConnectionsAllowed&) = delete;
  ConnectionsAllowed& operator=(const ConnectionsAllowed&) = delete;
  ~ConnectionsAllowed();
};

}  // namespace tramline::io
