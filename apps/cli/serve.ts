import { flushCompileCache } from 'node:module'
import { resolve } from 'node:path'
import {
  CannotServe,
  inRepository,
  openClassServer,
  openPage,
  startServer,
  writeLink,
  type ClassServer,
  type RunningServer,
} from '@botgarten/server'
import { whenParentEnds } from '@botgarten/server/parent'
import { codeInTerminal } from '@botgarten/server/terminal'
import root from '../../package.json' with { type: 'json' }
import type { Command } from './commands.ts'
import { CallError, FileError } from './errors.ts'
import { options, refuseMore, wholeNumberIn } from './options.ts'
import { message } from './words.ts'
import { sayProblem } from './serve-problems.ts'

const known = {
  port: { type: 'string' },
  host: { type: 'string' },
  data: { type: 'string' },
  database: { type: 'string' },
  'behind-proxy': { type: 'string' },
  'public-address': { type: 'string' },
  'start-over': { type: 'boolean' },
  https: { type: 'boolean' },
  open: { type: 'boolean' },
  rehearse: { type: 'string' },
  seconds: { type: 'string' },
  json: { type: 'boolean' },
} as const

type Values = ReturnType<typeof options<typeof known>>['values']

/** `botgarten serve`: the lab and the class, until it is stopped. It is what `npm start` runs. */
export const serve: Command = { options: known, execute: open }

/** Where a class server listens where no port is named. */
export const usualPort = 4173
/** In which folder all of a class server lies where none is named; what starts an unpacked zip names one outside of it. */
export const usualData = process.env['BOTGARTEN_DATA'] || inRepository('data')

async function open(args: string[]): Promise<string> {
  const { values, positionals } = options(args, known)
  refuseMore(positionals)
  const port = wholeNumberIn('port', values.port, usualPort, 0, 65_535)
  const folder = values.data ?? usualData
  if (values.rehearse !== undefined) return rehearsal(values, folder)
  try {
    const classServer = await openClassServer({ ...classOptions(values), data: folder })
    const server = await listen(classServer, { port, host: values.host, https: values.https ? folder : null })
    stopWhenTold(server)
    // Where the plug is pulled there is no end at which Node would keep what it has compiled.
    flushCompileCache()
    const token = await classServer.firstTeacher()
    if (values.open) openPage(`${server.url}/here${token === null ? '' : `#${token}`}`)
    const kept = values.database === undefined ? message('serve.kept', { folder: resolve(folder) }) : ''
    return [greeting(server), kept, invitation(token, classServer, server, folder)]
      .filter(Boolean)
      .join('\n\n')
  } catch (error) {
    throw sayProblem(error)
  }
}

/** Plays a lesson and prints how it went. */
async function rehearsal(values: Values, data: string): Promise<string> {
  const pupils = wholeNumberIn('rehearse', values.rehearse, 35, 1, 200)
  const seconds = wholeNumberIn('seconds', values.seconds, 60, 1, 7200)
  const { database } = classOptions(values)
  const { isGreen, rehearse } = await import('@botgarten/server/rehearsal')
  try {
    const figures = await rehearse({ data, database, pupils, seconds })
    const { saves, lost, p99, rss } = figures
    const green = isGreen(figures)
    if (!green) process.exitCode = 1
    if (values.json) return JSON.stringify({ pupils, saves, lost, p99, rss })
    const verdict = message(green ? 'serve.green' : 'serve.red')
    return message('serve.rehearsal', { verdict, pupils, saves, lost, p99, rss })
  } catch (error) {
    throw sayProblem(error)
  }
}

function classOptions(values: Values) {
  const {
    database,
    'behind-proxy': proxies,
    'public-address': address,
    'start-over': startOver = false,
  } = values
  if (database !== undefined && !/^postgres(ql)?:\/\//.test(database))
    throw new CallError('call.database', { text: database })
  const publicAddress = address === undefined ? undefined : originOf(address)
  return { database, publicAddress, proxies: proxies?.split(',').map((one) => one.trim()) ?? [], startOver }
}

function originOf(address: string): string {
  if (!URL.canParse(address) || !/^https?:$/.test(new URL(address).protocol))
    throw new CallError('call.address', { text: address })
  return new URL(address).origin
}

interface Listening {
  readonly port: number
  readonly host: string | undefined
  /** The folder of the certificates; null: http alone. */
  readonly https: string | null
}

async function listen(
  classServer: ClassServer,
  { port: wanted, host, https }: Listening,
): Promise<RunningServer> {
  try {
    return await startServer({ port: wanted, classServer, https, ...(host === undefined ? {} : { host }) })
  } catch (error) {
    await classServer.close()
    // Of two ports, the one that failed.
    const { code, port = wanted } = error as NodeJS.ErrnoException & { port?: number }
    if (code === 'EADDRINUSE') throw new FileError('serve.portTaken', { port, next: port + 1 })
    if (code === 'EACCES') throw new FileError('serve.portForbidden', { port, usual: usualPort })
    throw error instanceof CannotServe
      ? error
      : new FileError('serve.notOpened', { why: code ?? String(error) })
  }
}

function stopWhenTold(server: RunningServer) {
  // A page that was drawn here may have left something open that nobody closes.
  const stop = () => void server.close().finally(() => process.exit())
  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP'] as const) process.once(signal, stop)
  // Of `npm start`: npm passes no signal on to what it runs.
  if (process.env['BOTGARTEN_ENDS_WITH_PARENT']) whenParentEnds(stop)
}

const greeting = (server: RunningServer) =>
  message('serve.open', {
    addresses: server
      .addresses()
      .map((address) => `  ${address}`)
      .join('\n'),
    version: root.version,
  })

/** How the first teacher comes to an account; '' where there is one. The terminal sees the link, else a file has it. */
function invitation(
  token: string | null,
  classServer: ClassServer,
  server: RunningServer,
  folder: string,
): string {
  if (token === null) return ''
  const link = `${classServer.place().announced ?? server.url}/teacher/start#${token}`
  if (!process.stdout.isTTY) return message('serve.linkInFile', { path: writeLink(folder, link) })
  return message('serve.link', { link, code: codeInTerminal(link) })
}
