import { execFileSync } from 'node:child_process'
import {
  chmodSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs'
import { dirname, join } from 'node:path'
import { Trouble } from '../prepare/run.mjs'
import type { Entry } from '../zips/archive.ts'
import { plain, plainPath } from '../zips/plain.ts'
import { packagesIn } from './packages.ts'
import { diskId } from './partitions.ts'
import { fill } from './pi/slots.ts'
import units from './units.json' with { type: 'json' }

const suite = 'trixie'
const components = 'main non-free-firmware'
const keys = '/usr/share/keyrings/debian-archive-keyring.gpg'
const sources = [
  ['http://deb.debian.org/debian', suite],
  ['http://deb.debian.org/debian', `${suite}-updates`],
  ['http://deb.debian.org/debian-security', `${suite}-security`],
].map(([address, of]) => `deb [signed-by=${keys}] ${address} ${of} ${components}`)

const here = import.meta.dirname
const shell = (program: string, ...args: string[]) => execFileSync(program, args, { stdio: 'inherit' })

/** Programs of another chip run only where the kernel knows by what: Debian's package tells it where systemd runs. */
export function letKernelEmulate(): void {
  const registry = '/proc/sys/fs/binfmt_misc'
  if (process.arch === 'arm64' || existsSync(join(registry, 'qemu-aarch64'))) return
  try {
    if (!existsSync(join(registry, 'register'))) shell('mount', '-t', 'binfmt_misc', 'none', registry)
    const line = readFileSync('/usr/lib/binfmt.d/qemu-aarch64.conf', 'latin1').trim()
    writeFileSync(join(registry, 'register'), line, 'latin1')
  } catch (error) {
    throw new Trouble(
      `The kernel cannot be told to run programs for arm64 by QEMU (binfmt_misc): ${(error as Error).message}`,
    )
  }
}

/** Own files of the system, with the id of the partition table filled in. */
function layOver(tree: string) {
  const from = join(here, 'root')
  for (const path of readdirSync(from, { recursive: true, encoding: 'utf8' })) {
    const [source, target] = [join(from, path), join(tree, path)]
    if (!statSync(source).isFile()) continue
    mkdirSync(dirname(target), { recursive: true })
    rmSync(target, { force: true })
    writeFileSync(target, fill(readFileSync(source, 'utf8'), diskId))
    chmodSync(target, statSync(source).mode & 0o111 ? 0o755 : 0o644)
  }
}

/** Where programs that write into /etc or /var find another place, or none. */
function settle(tree: string) {
  writeFileSync(join(tree, 'etc/machine-id'), '')
  rmSync(join(tree, 'etc/resolv.conf'), { force: true })
  symlinkSync('/run/NetworkManager/resolv.conf', join(tree, 'etc/resolv.conf'))
  for (const path of ['var/lib/botgarten', 'var/lib/systemd/timesync', 'boot/firmware'])
    mkdirSync(join(tree, path), { recursive: true })
  for (const path of ['var/lib/apt', 'var/cache', 'var/log', 'var/tmp', 'tmp']) {
    rmSync(join(tree, path), { recursive: true, force: true })
    mkdirSync(join(tree, path))
  }
}

/** What is read by people on another computer. */
const unread = ['man', 'info', 'lintian', 'locale/*', 'doc/*'].map(
  (what) => `path-exclude=/usr/share/${what}`,
)

/**
 * A tree of Debian for arm64, with our own files in it before the first root is packed.
 * @param packages a folder where what was fetched stays for the next time
 */
export function makeTree(tree: string, overlay: string, packages: string): void {
  for (const folder of [overlay, packages]) mkdirSync(folder, { recursive: true })
  rmSync(tree, { recursive: true, force: true })
  layOver(overlay)
  const list = packagesIn(readFileSync(join(here, 'packages.txt'), 'utf8'))
  const archives = '"$1"/var/cache/apt/archives'
  shell(
    'mmdebstrap',
    ...['--mode=root', '--architectures=arm64', '--variant=essential', `--include=${list.join(',')}`],
    ...[...unread, 'path-include=/usr/share/doc/*/copyright'].map((option) => `--dpkgopt=${option}`),
    '--skip=essential/unlink,download/empty',
    `--setup-hook=mkdir -p ${archives}; cp ${packages}/*.deb ${archives}/ 2>/dev/null || true`,
    // Before the kernel is configured: what it packs into the first root is among them.
    `--essential-hook=cp -r --preserve=mode ${overlay}/. "$1"/; mkdir -p "$1"/boot/firmware`,
    `--customize-hook=cp -u ${archives}/*.deb ${packages}/ || true`,
    ...[suite, tree, ...sources],
  )
}

/** Own files, users and units, over what Debian brings. */
export function finishTree(tree: string): void {
  layOver(tree)
  settle(tree)
  shell('chroot', tree, 'systemd-sysusers')
  shell('chroot', tree, 'systemctl', 'enable', ...units.enable)
  for (const unit of units.mask) {
    rmSync(join(tree, 'etc/systemd/system', unit), { force: true })
    symlinkSync('/dev/null', join(tree, 'etc/systemd/system', unit))
  }
}

/** What runs on the Pi itself, as modules of a zip are: without types. */
function addPrograms(folder: string) {
  const from = join(here, 'pi')
  mkdirSync(folder)
  for (const name of readdirSync(from).filter((one) => !one.endsWith('.test.ts'))) {
    const [text, { mode }] = [readFileSync(join(from, name), 'utf8'), statSync(join(from, name))]
    writeFileSync(join(folder, plainPath(name)), name.endsWith('.ts') ? plain(text) : text, {
      mode: mode & 0o111 ? 0o755 : 0o644,
    })
  }
  writeFileSync(join(folder, 'package.json'), '{ "type": "module" }\n')
}

/** The lab as its zip has it, and the programs of the Pi beside it. */
export function addLab(tree: string, entries: readonly Entry[]): void {
  const folder = join(tree, 'opt/botgarten')
  rmSync(folder, { recursive: true, force: true })
  for (const { path, read, program } of entries) {
    if (/\.(txt|desktop)$/.test(path) && !path.includes('/')) continue
    mkdirSync(dirname(join(folder, path)), { recursive: true })
    writeFileSync(join(folder, path), read(), { mode: program ? 0o755 : 0o644 })
  }
  addPrograms(join(folder, 'pi'))
}
