import { globSync, readFileSync, statSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from 'vitest'
import { packagesIn } from './packages.ts'
import { diskId, partitions } from './partitions.ts'
import { fill } from './pi/slots.ts'
import { missing, toBuild, toTry } from './tools.ts'
import units from './units.json' with { type: 'json' }

const here = import.meta.dirname
const text = (path: string) => readFileSync(join(here, path), 'utf8')
const unitsBelow = globSync(join(here, 'root/etc/systemd/system/*'))

test('a list of packages is read without its reasons, and what is no name is refused', () => {
  expect(packagesIn('# Kernel\nlinux-image-arm64  # drives it\n\n  iw\n')).toEqual([
    'linux-image-arm64',
    'iw',
  ])
  expect(() => packagesIn('iw; rm\n')).toThrow('No name of a package: iw; rm')
})

test('the image has what its files speak of: kernel, firmware, hot spot, name, the country’s rules', () => {
  expect(packagesIn(text('packages.txt'))).toEqual(
    expect.arrayContaining([
      ...['linux-image-arm64', 'raspi-firmware', 'firmware-brcm80211', 'wireless-regdb', 'iw'],
      ...['network-manager', 'dnsmasq-base', 'nftables', 'avahi-daemon', 'zstd', 'fdisk', 'e2fsprogs'],
    ]),
  )
})

test('the command line of each system names its own root, read only', () => {
  const [a, b] = (['a', 'b'] as const).map((slot) => fill(text('boot/cmdline.txt'), diskId, slot))
  expect(a).toMatch(/^[^\n]* root=PARTUUID=b07a9a27-02 ro rootwait [^\n]*botgarten\.slot=a\n$/)
  expect(b).toMatch(/^[^\n]* root=PARTUUID=b07a9a27-03 ro rootwait [^\n]*botgarten\.slot=b\n$/)
  expect(partitions.map(({ name }) => name)).toEqual(['boot', 'a', 'b', 'data'])
})

test('nothing of the template is left in a file of the system', () => {
  for (const path of globSync(join(here, 'root/**/*')).filter((one) => statSync(one).isFile()))
    expect(fill(readFileSync(path, 'utf8'), diskId), path).not.toMatch(/@(disk|part|slot)@/)
})

test('every unit that starts by itself lies there, and what it starts does too', () => {
  const names = unitsBelow.map((path) => path.split('/').at(-1)!)
  const own = units.enable.filter((name) => name.startsWith('botgarten'))
  expect(names).toEqual(expect.arrayContaining(own))
  for (const path of unitsBelow)
    for (const [, program, name] of readFileSync(path, 'utf8').matchAll(
      /^ExecStart=-?\/opt\/botgarten\/pi\/(\S+)(?: (\S+))?/gm,
    )) {
      expect(statSync(join(here, 'pi', program!)).mode & 0o100, program).toBe(0o100)
      if (program === 'run.sh') expect(statSync(join(here, 'pi', `${name}.ts`)).isFile()).toBe(true)
    }
})

test('the lab runs as nobody special, on a root that it cannot write, watched', () => {
  expect(text('root/etc/systemd/system/botgarten.service')).toMatch(/^User=botgarten$/m)
  for (const line of ['ProtectSystem=strict', 'NoNewPrivileges=yes', 'WatchdogSec=90', 'Restart=always'])
    expect(text('root/etc/systemd/system/botgarten.service')).toContain(`\n${line}\n`)
  expect(text('root/etc/fstab')).not.toMatch(/\s\/\s/)
  expect(text('root/etc/systemd/system.conf.d/botgarten.conf')).toMatch(/^RuntimeWatchdogSec=1[0-5]s$/m)
})

test('what is missing is named, with the package that brings it', () => {
  expect(missing(toBuild, () => true)).toBe(null)
  expect(missing(toTry, (program) => program !== 'debugfs' && program !== 'mkfs.vfat')).toBe(
    'Missing: mkfs.vfat, debugfs. On Debian: apt-get install --no-install-recommends dosfstools e2fsprogs',
  )
})
