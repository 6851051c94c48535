import { fork, type ChildProcess } from 'node:child_process'
import { fileURLToPath } from 'node:url'
import type { Question, Reply } from './child-process.ts'

const script = fileURLToPath(new URL('./child-process.ts', import.meta.url))

/** A class server in a process that is killed while it works, and started again. */
export class KilledServer {
  private process: ChildProcess | null = null
  private readonly address: string
  private count = 0

  constructor(address: string) {
    this.address = address
  }

  async start(): Promise<void> {
    const running = fork(script, [this.address], { execArgv: ['--disable-warning=ExperimentalWarning'] })
    this.process = running
    await new Promise((resolve, reject) => {
      running.once('message', resolve)
      running.once('exit', reject)
    })
    running.removeAllListeners('exit')
  }

  /** Ends it at once, as a pulled plug does. */
  async kill(): Promise<void> {
    const running = this.process!
    const ended = new Promise((resolve) => running.once('exit', resolve))
    running.kill('SIGKILL')
    await ended
  }

  /** @returns null where the server was killed before it answered */
  ask(question: Omit<Question, 'id'>): Promise<Reply | null> {
    const [id, running] = [++this.count, this.process!]
    return new Promise((resolve) => {
      const end = (reply: Reply | null) => {
        running.off('message', hear)
        running.off('exit', gone)
        resolve(reply)
      }
      const hear = (reply: Reply) => reply.id === id && end(reply)
      const gone = () => end(null)
      running.on('message', hear)
      running.on('exit', gone)
      if (running.connected) running.send({ ...question, id }, (error) => error && end(null))
      else end(null)
    })
  }
}
