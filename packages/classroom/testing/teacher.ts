import type { Database } from '../database/database.ts'
import type { Browser } from './browser.ts'
import type { Server } from './world.ts'

const known = new WeakSet<Database>()

/** A browser with the teacher of a database signed in: tests that begin with a server of their own share one database. */
export async function teacherOn(server: Server): Promise<Browser> {
  const { database } = server.ports
  if (!known.has(database)) {
    known.add(database)
    return server.firstTeacher()
  }
  const browser = server.browser()
  await browser.post('/auth/sign-in/username', { username: 'm.weber', password: 'kastanie im regen' })
  return browser
}
