#!/usr/bin/perl
# Makes the state that a killed POV-Ray left fit to be taken up again: traced.pl STATE
#
# What was cut off in the middle goes, as POV-Ray would write on behind it. And with radiosity it begins by drawing one
# coarse pixel, as large as the picture, for its first block, unless that one is done: it would cover all others, so these
# go, too, where the first is missing. POV-Ray begins with it; only threads that run beside it can be faster.
use strict;
use warnings;

my $usage = "Usage: scripts/traced.pl STATE\n\nKeeps what POV-Ray can go on from of the state that it left when it was killed.\n";
if (@ARGV && $ARGV[0] =~ /^(-h|--help)$/) { print $usage; exit 0 }
if (@ARGV != 1) { print STDERR $usage; exit 2 }

# A head of 512 bytes; then messages, whose bytes 12 to 16 are their length without 20 bytes: PxSe coarse pixels, PxBS blocks.
open(my $file, '+<:raw', $ARGV[0]) or die "$ARGV[0]: $!\n";
my ($size, $at, $coarse, $first) = (-s $file, 512, 0, 0);
my $message;
exit 0 if read($file, $message, 25) < 25 || $message ne 'POV-Ray Render State File';    # another renderer's
while ($at + 16 <= $size && seek($file, $at, 0) && read($file, $message, 16) == 16 && $message =~ /^POVRAYMS/) {
  my $length = 20 + unpack 'x12 N', $message;
  last if $at + $length > $size;
  read $file, $message, $length - 16;
  $coarse ||= substr($message, 0, 128) =~ /PxSe/;
  $first ||= $message =~ /PiIdINT4\x00{3}\x04\x00{4}PiSi/;
  $at += $length;
}
$at = 0 if $at == 512 || $coarse && !$first;
truncate $file, $at or die "$ARGV[0]: $!\n" if $at < $size;
