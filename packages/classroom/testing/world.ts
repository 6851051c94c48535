import { content } from '@botgarten/content/files'
import type { Database } from '../database/database.ts'
import { handle } from '../handle.ts'
import type { Caller, LogLine, Ports, Tombstone } from '../ports.ts'
import { checkProject } from '../projects/checked.ts'
import { noBus } from '../live/bus.ts'
import { Limits } from '../limits.ts'
import { Hub } from '../live/hub.ts'
import { saveQueueOn } from '../projects/save-queue.ts'
import { hashOf } from '../hashes.ts'
import { accountsOn, type Hashing } from '../teaching/accounts.ts'
import { firstTeacherToken } from '../teaching/first-teacher.ts'
import { Browser } from './browser.ts'

const secret = new Uint8Array(32).fill(7)

/** Hashes for tests that are about something else than passwords. */
export const quickHashes: Hashing = {
  hash: (password) => Promise.resolve(hashOf(password)),
  verify: ({ hash, password }) => Promise.resolve(hash === hashOf(password)),
}

/** Ports of a server whose teachers sign in at once. */
export const quickAccounts = (database: Database): Pick<Ports, 'accounts'> => ({
  accounts: accountsOn(database, secret, Date.now, quickHashes),
})

/** A class server in a test: a real database, a clock that is set by hand, and what it logged and buried. */
export class Server {
  readonly ports: Ports
  readonly logged: LogLine[] = []
  readonly buried: Tombstone[] = []
  /** A Tuesday in November, 8 o'clock. */
  now = Date.UTC(2026, 10, 24, 8)
  /** Ms that have passed by `later`, on every clock. */
  private ahead = 0
  private isHeld = false

  constructor(database: Database, changes: Partial<Ports> = {}) {
    this.ports = {
      database,
      now: () => this.now,
      steady: () => this.steady(),
      day: (offset) => new Date(this.now + offset * 86_400_000).toISOString().slice(0, 10),
      random: (bytes) => crypto.getRandomValues(new Uint8Array(bytes)),
      secret,
      accounts: accountsOn(database, secret, Date.now),
      checkProject: (text) => Promise.resolve(checkProject(text)),
      save: saveQueueOn(database),
      bury: (tombstone) => Promise.resolve(void this.buried.push(tombstone)),
      log: (line) => void this.logged.push(line),
      publicOrigin: null,
      announced: () => 'http://lab.test',
      teacherMade: () => {},
      limits: new Limits(() => this.elapsed()),
      live: new Hub(noBus, { now: () => this.now, elapsed: () => this.ahead }),
      cards: () =>
        Promise.resolve([{ id: 'friendship', starts: 3, title: { en: 'Friendship', de: 'Freundschaft' } }]),
      questionnaires: () => Promise.resolve({ forms: content.forms, questions: content.questions }),
      host: {
        ...{
          memory: () => 1,
          freeSpace: () => 1,
          useReserve: () => {},
          addresses: () => ['http://lab.test'],
        },
        ...{ otherDevice: () => null, wifi: null, version: '0.1.0' },
        findings: () => [
          { verdict: 'version.is', fine: true, facts: {} },
          { verdict: 'folder.inUse', fine: true, facts: {} },
        ],
        ...{ backups: () => ({ count: 0, last: null, broken: 0 }), backUp: () => Promise.resolve() },
        newestBackup: () => null,
        rehearse: ({ pupils, seconds }, hear) => {
          hear({ pupils, joined: pupils, saves: 1, slowest: 7, seconds: 1, of: seconds })
          return Promise.resolve({ green: true, pupils, saves: 2, lost: 0, p99: 7, slowest: 7, rss: 90 })
        },
      },
      ...changes,
    }
  }

  later(minutes: number) {
    this.passes(minutes * 60_000)
  }

  /** Time passes on every clock. `now` alone is a clock that is set. */
  passes(ms: number) {
    this.now += ms
    // The others never go back.
    this.ahead += Math.max(0, ms)
  }

  /** Time that is only passed by `later`, and not by setting the clock. */
  steady(): number {
    return Date.UTC(2026, 10, 24, 8) + Math.floor(this.ahead)
  }

  private elapsed(): number {
    return this.ahead + (this.isHeld ? 0 : performance.now())
  }

  /** From now on the clock of the limits, too, is set by `later` alone. */
  holdClock() {
    this.ahead = this.elapsed()
    this.isHeld = true
  }

  ask(request: Request, caller: Partial<Caller> = {}) {
    return handle(request, this.ports, {
      ...{ address: '192.168.0.9', secure: false, reached: '192.168.0.5' },
      ...caller,
    })
  }

  browser(address = '192.168.0.9') {
    return new Browser((request) => this.ask(request, { address }))
  }

  /** A browser with the first teacher signed in. */
  async firstTeacher(username = 'm.weber') {
    const token = (await firstTeacherToken(this.ports))!
    const teacher = this.browser()
    await teacher.post('/teachers', { token, username, password: 'kastanie im regen' })
    return teacher
  }

  /** A browser with a further teacher signed in. */
  async furtherTeacher(operator: Browser, username = 'k.otto') {
    const { token } = (await operator.post('/invitations')).body as { token: string }
    const teacher = this.browser()
    await teacher.post('/teachers', { token, username, password: 'ein anderer satz' })
    return teacher
  }

  /** A class that can be joined. */
  async openClass(teacher: Browser, name = '5b') {
    const { id } = (await teacher.post('/classes', { name, language: 'en', grade: 5, endsOn: '2027-01-31' }))
      .body as { id: string }
    await teacher.post(`/classes/${id}/open`)
    const { code } = (await teacher.get(`/classes/${id}`)).body as { code: string }
    return { id, code }
  }

  /** A browser whose pupil has just joined. */
  async pupil(code: string, nickname: string) {
    const browser = this.browser()
    const { body } = await browser.post('/join', { code, nickname })
    return { browser, ...(body as { id: string; class: string; pictures: readonly string[] }) }
  }
}
