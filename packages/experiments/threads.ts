import { availableParallelism } from 'node:os'
import { Worker } from 'node:worker_threads'

/**
 * Answers to all pieces of work, in their order, worked out by so many threads: each is told one piece at a time.
 * @param script answers every message that it is sent with one of its own
 * @param done hears how many are ready
 */
export async function inThreads<Work, Answer>(
  script: URL,
  all: readonly Work[],
  threads = availableParallelism(),
  done: (count: number) => void = () => undefined,
): Promise<Answer[]> {
  const answers: Answer[] = []
  let next = 0
  let ready = 0
  const work = () =>
    new Promise<void>((finished, failed) => {
      const worker = new Worker(script)
      let mine = -1
      const give = () => {
        mine = next++
        if (mine < all.length) worker.postMessage(all[mine])
        else void worker.terminate().then(() => finished())
      }
      worker.on('error', failed)
      worker.on('message', (answer: Answer) => {
        answers[mine] = answer
        done(++ready)
        give()
      })
      give()
    })
  await Promise.all(Array.from({ length: Math.min(threads, all.length) }, work))
  return answers
}
