#!/usr/bin/perl
# Runs a program that can open no file but those it is given: confined.pl [--read PATH | --write FOLDER]... -- PROGRAM ARGUMENT...
#
# By Landlock (Linux 5.13), which the kernel keeps to whatever the program does. Besides what is named, it may read and run
# what the system's programs are made of. Call it under `setpriv --no-new-privs`. Exit code 3: the kernel has no Landlock.
use strict;
use warnings;

my $usage = "Usage: scripts/confined.pl [--read PATH | --write FOLDER]... -- PROGRAM [ARGUMENT...]\n\n"
  . "Runs a program that can open nothing but what is below these paths, and the system's programs and libraries.\n"
  . "Where the kernel cannot do that, FROND_UNCONFINED=1 makes scripts/render_frame.sh do without.\n";
if (@ARGV && $ARGV[0] =~ /^(-h|--help)$/) { print $usage; exit 0 }

# Of linux/landlock.h. The numbers of its calls are the same on every processor.
my ($create, $add, $restrict) = (444, 445, 446);
my ($execute, $write, $read, $list, $remove, $make, $truncate) = map { 1 << $_ } 0, 1, 2, 3, 5, 8, 14;
my $on_files = $execute | $write | $read | $truncate;    # what a rule of a file may hold; that of a folder holds all

my $version = syscall($create, 0, 0, 1);
if ($version < 1) {
  print STDERR "this kernel has no Landlock (Linux 5.13), which keeps programs to their folders; see --help\n";
  exit 3;
}
my $handled = 0x1fff | ($version >= 2 ? 1 << 13 : 0) | ($version >= 3 ? $truncate : 0);
my $attributes = pack 'Q', $handled;
my $rules = syscall($create, $attributes, 8, 0);
die "Landlock: $!\n" if $rules < 0;

sub allow {
  my ($path, $rights) = @_;
  sysopen(my $place, $path, 010000000) or return 0;    # O_PATH
  $rights &= $on_files unless -d $path;
  my $rule = pack 'Ql', $rights & $handled, fileno $place;
  syscall($add, $rules, 1, $rule, 0) == 0 or die "$path: Landlock: $!\n";
  return 1;
}

allow($_, $execute | $read | $list) for qw(/usr /bin /lib /lib32 /lib64);
allow($_, $read) for qw(/etc/ld.so.cache /etc/localtime);
allow('/dev/null', $read | $write);
while (@ARGV && $ARGV[0] ne '--') {
  my ($how, $path) = splice @ARGV, 0, 2;
  my $rights = $how eq '--read' ? $read | $list : $read | $list | $write | $make | $remove | $truncate;
  if ($how !~ /^--(read|write)$/ || !defined $path) { print STDERR $usage; exit 2 }
  allow($path, $rights) or die "$path: $!\n";
}
shift @ARGV;
if (!@ARGV) { print STDERR $usage; exit 2 }
allow($ARGV[0], $execute | $read);

syscall($restrict, $rules, 0) == 0 or die "Landlock: $!\n";
exec { $ARGV[0] } @ARGV or die "$ARGV[0]: $!\n";
