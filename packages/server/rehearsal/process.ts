// Plays one rehearsal in a process of its own, so that nothing of it stays in the memory of the server. It ends with
// the process that started it, and when that one lets go of it.
import { rehearse, isGreen, type Rehearsal } from './rehearse.ts'

const stop = new AbortController()
const answer = (message: object) => void (process.connected && process.send!(message))

process.once('disconnect', () => stop.abort())
process.once('message', (wish: Omit<Rehearsal, 'hear' | 'signal'>) => void play(wish))

async function play(wish: Omit<Rehearsal, 'hear' | 'signal'>) {
  try {
    const hear = (progress: object) => answer({ progress })
    const figures = await rehearse({ ...wish, hear, signal: stop.signal })
    const { pupils, saves, lost, p99, slowest, rss } = figures
    answer({ done: { green: isGreen(figures), pupils, saves, lost, p99, slowest, rss } })
  } catch (error) {
    answer({ failed: error instanceof Error ? error.message : String(error) })
  }
  if (process.connected) process.disconnect()
}
