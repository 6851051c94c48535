import { fork } from 'node:child_process'
import { once } from 'node:events'
import type { Host, RehearsalOutcome, RehearsalProgress } from '@botgarten/classroom'
import { inRepository } from './repository.ts'

type Message =
  { readonly progress: RehearsalProgress } | { readonly done: RehearsalOutcome } | { readonly failed: string }

interface Place {
  readonly data: string
  readonly database?: string | undefined
}

/** Plays rehearsals beside this server, one at a time, each in a process of its own. */
export function rehearsalsAt(place: Place): Host['rehearse'] {
  /** Of the one that is being played: when its process has ended. Stopped, the next one waits for it. */
  let running: { readonly ended: Promise<unknown>; readonly signal: AbortSignal } | null = null

  async function play(
    before: Promise<unknown> | undefined,
    ...[wish, hear, signal]: Parameters<Host['rehearse']>
  ): Promise<RehearsalOutcome> {
    await before
    signal.throwIfAborted()
    const played = fork(inRepository('packages', 'server', 'rehearsal', 'process.ts'), {
      execArgv: ['--disable-warning=ExperimentalWarning'],
      stdio: ['ignore', 'ignore', 'ignore', 'ipc'],
    })
    const stop = () => void (played.connected && played.disconnect())
    signal.addEventListener('abort', stop, { once: true })
    let result: RehearsalOutcome | string = 'The rehearsal ended without an outcome.'
    played.on('message', (message: Message) => {
      if ('progress' in message) hear(message.progress)
      else result = 'done' in message ? message.done : message.failed
    })
    played.send({ ...place, ...wish })
    await once(played, 'exit')
    signal.removeEventListener('abort', stop)
    signal.throwIfAborted()
    if (typeof result === 'string') throw new Error(result)
    return result
  }

  return (wish, hear, signal) => {
    if (running && !running.signal.aborted) return null
    const outcome = play(running?.ended, wish, hear, signal)
    const mine = { ended: outcome.catch(() => {}), signal }
    running = mine
    void mine.ended.then(() => {
      if (running === mine) running = null
    })
    return outcome
  }
}
