// SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK's errors and warnings, so that a user sees one line for each.
#ifndef Messages_h
#define Messages_h

#include <iosfwd>
#include <sstream>
#include <string>

/**
 * The text without line ends and other control characters, and, if it is no UTF-8,
 * without what is no ASCII: messages may quote what a file holds.
 */
std::string OneLine(std::string text);

/**
 * While it lives, VTK and the libraries that it reads files by write nothing to
 * stderr. Errors are kept until asked for; warnings until ShowWarnings(), since
 * those that come before an error say nothing that the error does not. Until then,
 * VTK's generic warnings count as errors.
 */
class MessageKeeper
{
public:
  MessageKeeper();
  ~MessageKeeper();
  MessageKeeper(const MessageKeeper&) = delete;
  void operator=(const MessageKeeper&) = delete;

  /**
   * The first error since the last call, in one line, or an empty string.
   */
  static std::string TakeError();

  /**
   * As a warning of VTK's.
   */
  static void AddWarning(const std::string& text);

  /**
   * Prints the warnings kept so far; later ones are printed as they come.
   */
  static void ShowWarnings();

private:
  std::ostringstream Swallowed;
  std::streambuf* Before;
};

#endif
