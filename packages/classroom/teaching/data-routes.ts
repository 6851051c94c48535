import * as v from 'valibot'
import { sharedOf } from '../gallery/about-pupil-store.ts'
import { countAllShared } from '../gallery/shared-store.ts'
import { daysOfCopies } from '../hosting/copies.ts'
import { markPhraseShown, phraseOf, phraseShown } from '../hosting/phrase-store.ts'
import { pupilsOf } from '../joining/pupils-store.ts'
import type { Finding, Ports } from '../ports.ts'
import { mostSpace } from '../projects/space-store.ts'
import { askingsOf } from '../questionnaires/askings-store.ts'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { newestIn } from './about-pupil.ts'
import { sizesOf } from './classes-store.ts'
import { endsSoon } from './ending-store.ts'
import { isOperator } from './operators-store.ts'
import { provePassword } from './prove-password.ts'
import { resultsOf } from './results-store.ts'
import { daysNow } from './running-days-store.ts'
import { arrayOf, streamed } from './streamed.ts'

/** What is kept of a class, how much, until when. */
async function data({ ports, who }: Call<undefined>): Promise<Answer> {
  const { id, space, endsOn } = who.class!
  const sizes = await sizesOf(ports.database.db, id)
  return {
    body: {
      ...sizes,
      ...{ space, mostSpace: mostSpace.class, endsOn, endsSoon: endsSoon({ endsOn }, ports.day) },
      shared: await countAllShared(ports.database.db, id),
      results: (await resultsOf(ports.database.db, id)).length,
      forms: (await askingsOf(ports.database.answers.db, id)).length,
      backups: ports.host.backups(),
      /** Deleted today, it is in no copy from the server's first start or night on that this day has. */
      goneFromBackupsOn: ports.day(daysOfCopies),
    },
  }
}

/** A class as one JSON text, a project at a time. */
async function* pieces({ database: { db } }: Ports, name: string, classId: string) {
  yield `{"class":${JSON.stringify(name)},"pupils":[`
  let first = true
  for (const { id, nickname, joinedAt } of await pupilsOf(db, classId)) {
    yield `${first ? '' : ','}{"nickname":${JSON.stringify(nickname)},"joinedAt":${joinedAt},"projects":`
    first = false
    yield* arrayOf(newestIn(db, id))
    yield ',"shared":'
    yield* arrayOf(sharedOf(db, id))
    yield '}'
  }
  yield ']}'
}

function exported({ ports, who }: Call<undefined>): Promise<Response> {
  const slot = ports.limits.exports.enter(who.teacher!.id)
  return Promise.resolve(streamed(pieces(ports, who.class!.name, who.class!.id), 'class', slot))
}

/** How the server is: for the page of the first start, and for who runs it. */
const health = ({ ports, caller }: Call<undefined>): Promise<Answer> =>
  Promise.resolve({
    body: {
      ...{ now: ports.now(), secure: caller.secure, database: ports.database.kind },
      ...{
        memory: ports.host.memory(),
        freeSpace: ports.host.freeSpace(),
        addresses: ports.host.addresses(),
      },
      ...{ otherDevice: ports.host.otherDevice(), version: ports.host.version },
      ...{ backups: ports.host.backups(), streams: ports.live.size },
    },
  })

/** Findings of the machine with the one of the days of running: these are in the database. */
async function withClock({ database, day }: Ports, all: readonly Finding[]): Promise<readonly Finding[]> {
  const { last, doubt } = await daysNow({ db: database.db, clock: day })
  // A clock that was never set is found out by the age of files.
  if (doubt === null || last === null) return all
  const verdict = doubt.denied ? 'clock.denied' : 'clock.doubted'
  const doubted = { verdict, fine: false, facts: { now: day(0), last } }
  return [...all.filter((finding) => finding.verdict !== 'clock.fine'), doubted]
}

/** The same in sentences. Where things lie on the machine is for who runs it alone. */
async function findings({ ports, who }: Call<undefined>): Promise<Answer> {
  const all = await withClock(ports, ports.host.findings(ports.live.size))
  const operates = await isOperator(ports.database.db, who.teacher!.id)
  return { body: { findings: operates ? all : all.filter(({ verdict }) => !verdict.startsWith('folder.')) } }
}

async function backUp({ ports }: Call<undefined>): Promise<Answer> {
  if (!ports.database.backup) throw new Refusal(409, 'byOwnTools')
  await ports.host.backUp()
  return { body: { backups: ports.host.backups() } }
}

/** The newest backup as a file: encrypted, so that it may lie anywhere. */
function download({ ports }: Call<undefined>): Promise<Response> {
  const newest = ports.host.newestBackup()
  if (newest === null) throw new Refusal(404, 'noBackup')
  const headers = {
    'content-type': 'application/octet-stream',
    'content-length': String(newest.size),
    'content-disposition': `attachment; filename="botgarten-${newest.name}"`,
  }
  return Promise.resolve(new Response(newest.body, { headers }))
}

/** The passphrase of the backups: the first time for the asking, from then on for the password. */
async function showPhrase({ ports, who, body }: Call<Asked>): Promise<Answer> {
  const { database, secret } = ports
  if (!database.backup) throw new Refusal(409, 'byOwnTools')
  if (await phraseShown(database.db)) {
    if (body.password === null) throw new Refusal(403, 'passwordNeeded')
    await provePassword(ports, who.teacher!.id, body.password)
  }
  const phrase = await phraseOf(database, secret)
  await markPhraseShown(database.db)
  return { body: { phrase } }
}

const asked = v.strictObject({ password: v.nullable(v.pipe(v.string(), v.maxLength(200))) })
type Asked = v.InferOutput<typeof asked>

export const dataRoutes: readonly Route[] = [
  route('GET', '/classes/:class/data', ['owner'], data),
  route('GET', '/classes/:class/export', ['owner'], exported),
  route('GET', '/health', ['teacher'], health),
  route('GET', '/findings', ['teacher'], findings),
  route('POST', '/backup', ['operator'], backUp),
  route('GET', '/backup', ['operator'], download),
  route('POST', '/backup/phrase', ['operator'], showPhrase, asked),
]
