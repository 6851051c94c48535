import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import type { IncomingMessage, ServerResponse } from 'node:http'
import { join, resolve } from 'node:path'
import {
  accountsOn,
  base,
  firstTeacherToken,
  handle,
  isKeyOf,
  lastBackup,
  migrate,
  NewerData,
  noBus,
  openDataFolder,
  openPostgres,
  secretIn,
  type Caller,
  type Database,
  type Ports,
} from '@botgarten/classroom'
import { brokenIn, prepareDataFolder } from './data-folder.ts'
import type { Here } from './here.ts'
import { callerOf, readAway, requestOf, send } from './http.ts'
import { lockFolder } from './lock.ts'
import { startLive } from './live.ts'
import { resetByFile } from './reset.ts'
import { startNights } from './nights.ts'
import { startSteady } from './steady.ts'
import { postgresBus } from './postgres-bus.ts'
import { dayHere, portsOn } from './ports.ts'
import { CannotServe, causeIn } from './problem.ts'
import { ReachedRecord } from './reached.ts'

export interface ClassOptions {
  /** The folder of database, key and backups. */
  readonly data: string
  /** `postgres://…` in place of the file in the folder. */
  readonly database?: string | undefined
  /** How pages reach the server where a proxy stands before it: `https://lab.example.org`. */
  readonly publicAddress?: string | undefined
  /** Addresses of proxies whose word on who asks counts. */
  readonly proxies?: readonly string[]
  /** Starts over although a broken database was set aside. */
  readonly startOver?: boolean
}

export interface ClassServer {
  readonly ports: Ports
  /** Is a request one to the class? */
  owns(path: string): boolean
  answer(request: IncomingMessage, response: ServerResponse): Promise<void>
  /** The secret of the link that makes the first teacher; null where there is one already. */
  firstTeacher(): Promise<string | null>
  /** What the machine that serves is told of it. */
  place(): Pick<Here, 'announced' | 'folder' | 'otherDevice'>
  /** The server listens. @param addresses under which it is reached, asked anew each time: networks come and go */
  reachedAt(addresses: () => readonly string[]): void
  close(): Promise<void>
}

/** Who asks on the machine that serves. */
const thisMachine: Caller = { address: '127.0.0.1', secure: true, reached: '127.0.0.1' }

const linkFile = 'first-teacher.txt'

/** For who starts the server without a terminal: the link in a file that its owner alone can read. */
export function writeLink(folder: string, link: string): string {
  const path = join(folder, linkFile)
  rmSync(path, { force: true })
  writeFileSync(path, `${link}\n`, { mode: 0o600, flag: 'wx' })
  return path
}

const cannotOpen = (error: unknown) =>
  error instanceof NewerData
    ? new CannotServe('newerData')
    : new CannotServe('noDatabase', { why: causeIn(error) })

async function openFile(folder: string, secret: Uint8Array, startOver: boolean): Promise<Database> {
  const before = startOver ? null : brokenIn(folder)
  const opened =
    before === null
      ? await openDataFolder(folder, { secret, day: dayHere(0) }).catch((error: unknown) => {
          throw cannotOpen(error)
        })
      : { kind: 'broken' as const, aside: before, lastBackup: lastBackup(folder)?.file ?? null }
  if (opened.kind === 'open') return opened.database
  const { aside, lastBackup: backup } = opened
  throw backup === null
    ? new CannotServe('broken', { path: aside })
    : new CannotServe('brokenWithBackup', { path: aside, backup })
}

async function openServer(address: string): Promise<Database> {
  try {
    const database = openPostgres(address)
    await migrate(database)
    return database
  } catch (error) {
    throw cannotOpen(error)
  }
}

/** The key of codes and pictures. Several nodes on one database share it: `BOTGARTEN_KEY` names its file. */
export function keyFor(folder: string): Uint8Array {
  const named = process.env['BOTGARTEN_KEY']
  if (!named) return secretIn(folder)
  if (!existsSync(named)) throw new CannotServe('noKey', { path: named })
  const key = new Uint8Array(readFileSync(named))
  if (key.length < 32) throw new CannotServe('noKey', { path: named })
  return key
}

/** Under another key no cookie, no picture and no password link of the database is worth anything. */
async function checkKey(database: Database, secret: Uint8Array, path: string) {
  if (await isKeyOf(database, secret)) return
  await database.close()
  throw new CannotServe('otherKey', { path })
}

/**
 * Opens the class server of a folder.
 * @throws {CannotServe} where the folder is in use, is no place for it, or its database is broken
 */
export async function openClassServer(options: ClassOptions): Promise<ClassServer> {
  const folder = prepareDataFolder(options.data)
  const free = lockFolder(folder)
  try {
    const secret = keyFor(folder)
    const database = await (options.database === undefined
      ? openFile(folder, secret, options.startOver ?? false)
      : openServer(options.database))
    await checkKey(database, secret, folder)
    await resetByFile({ accounts: accountsOn(database, secret, Date.now) }, folder)
    return await serverOn(database, secret, folder, options, free)
  } catch (error) {
    free()
    throw error
  }
}

async function serverOn(
  database: Database,
  secret: Uint8Array,
  folder: string,
  { publicAddress, proxies = [], database: address }: ClassOptions,
  free: () => void,
): Promise<ClassServer> {
  const teacherMade = () => rmSync(join(folder, linkFile), { force: true })
  const bus = address === undefined ? noBus : postgresBus(address)
  let addresses: () => readonly string[] = () => []
  const record = new ReachedRecord(folder)
  const steady = await startSteady(database)
  const { ports, close } = portsOn(database, secret, {
    folder,
    address,
    publicAddress: publicAddress ?? null,
    proxied: proxies.length > 0,
    ...{ teacherMade, steady: steady.now },
    reached: { addresses: () => addresses(), record },
    bus,
  })
  const stopLive = startLive(ports.live)
  // Before the first answer: a class that has ended is not shown once more.
  const stopNights = await startNights(ports, folder)
  /** What is being answered; the database stays open for it. */
  const inHand = new Set<Promise<unknown>>()

  function handled(request: Request, caller: Caller): Promise<Response> {
    const answering = handle(request, ports, caller)
    inHand.add(answering)
    void answering.finally(() => inHand.delete(answering))
    return answering
  }

  async function answer(incoming: IncomingMessage, response: ServerResponse) {
    let request: Request
    try {
      request = requestOf(incoming)
    } catch {
      return void response.writeHead(405).end()
    }
    const caller = callerOf(incoming, proxies)
    record.note(caller.address, ports.now())
    await send(await handled(request, caller), response)
    if (!incoming.complete) readAway(incoming)
  }

  return {
    ports,
    owns: (path) => path === base || path.startsWith(`${base}/`),
    answer,
    firstTeacher: () => firstTeacherToken(ports),
    place: () => ({
      announced: ports.announced(thisMachine),
      ...{ folder: resolve(folder), otherDevice: record.otherDevice },
    }),
    reachedAt(now) {
      addresses = now
      record.startAt(now())
    },
    async close() {
      stopLive()
      await ports.live.close()
      await stopNights()
      await Promise.all(inHand)
      await steady.stop()
      await close()
      await database.close()
      free()
    },
  }
}
