import { spawn, type ChildProcess } from 'node:child_process'
import { once } from 'node:events'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { serverEnv, serverFlags } from '../flags.mjs'
import { inRepository } from '../repository.ts'

export interface NodeOptions {
  readonly data: string
  readonly database?: string | undefined
  readonly port?: number
  /** What runs Node, such as `taskset -c 1`. */
  readonly prefix?: readonly string[]
  /** Further options of Node. */
  readonly flags?: readonly string[]
  /** What runs `botgarten` in place of these sources: the start script of an unpacked zip. */
  readonly program?: string
  readonly env?: NodeJS.ProcessEnv
}

/** A server in a process of its own. */
export interface ServingNode {
  readonly port: number
  readonly url: string
  readonly process: ChildProcess
  /** Secret of the link for the first teacher, as the server has written it. @throws where there is a teacher already */
  token(): string
  stop(): Promise<void>
  /** Ends it at once, as a pulled plug does. */
  kill(): Promise<void>
}

async function portOf(running: ChildProcess): Promise<number> {
  let [output, errors] = ['', '']
  running.stderr!.on('data', (part) => (errors += String(part)))
  return await new Promise((resolve, reject) => {
    running.stdout!.on('data', (part) => {
      output += String(part)
      const port = /http:\/\/localhost:(\d+)/.exec(output)?.[1]
      if (port !== undefined) resolve(Number(port))
    })
    running.once('error', reject)
    running.once('exit', () => reject(new Error(errors)))
  })
}

const sources = (flags: readonly string[]) => [
  ...[process.execPath, '--disable-warning=ExperimentalWarning', ...serverFlags, ...flags],
  inRepository('apps', 'cli', 'botgarten.ts'),
]

/** Starts `botgarten serve` and waits until it answers. */
export async function startNode({
  data,
  database,
  port = 0,
  prefix = [],
  flags: further = [],
  program,
  env = {},
}: NodeOptions): Promise<ServingNode> {
  const address = database === undefined ? [] : ['--database', database]
  const serve = ['serve', '--port', String(port), '--data', data, '--lang', 'en', ...address]
  const [first = '', ...args] = [
    ...prefix,
    ...(program === undefined ? sources(further) : [program]),
    ...serve,
  ]
  const running = spawn(first, args, {
    env: { ...process.env, ...(program === undefined ? serverEnv : {}), ...env },
    stdio: ['ignore', 'pipe', 'pipe'],
  })
  const opened = await portOf(running)
  const end = async (signal: NodeJS.Signals) => {
    if (running.exitCode !== null || running.signalCode !== null) return
    const ended = once(running, 'exit')
    running.kill(signal)
    await ended
  }
  return {
    ...{ port: opened, url: `http://localhost:${opened}`, process: running },
    token: () => readFileSync(join(data, 'first-teacher.txt'), 'utf8').trim().split('#')[1]!,
    stop: () => end('SIGTERM'),
    kill: () => end('SIGKILL'),
  }
}
