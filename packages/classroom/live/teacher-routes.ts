import * as v from 'valibot'
import type { ClassRow } from '../database/tables.ts'
import { newToken } from '../hashes.ts'
import { isLocked, pupilOf, pupilsOf } from '../joining/pupils-store.ts'
import { projectsOf, versionOf } from '../projects/projects-store.ts'
import type { Ports } from '../ports.ts'
import { Refusal } from '../refusal.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { changeClass, classById } from '../teaching/classes-store.ts'
import { isHidden } from '../teaching/ending-store.ts'
import { shownClass } from '../teaching/shown.ts'
import type { Who } from '../who.ts'
import { addHandout } from './handouts-store.ts'
import { free, handout } from './schema.ts'
import { inOrder, type Tile } from './tiles.ts'

async function tilesOf({ database, live, now }: Ports, classId: string): Promise<Tile[]> {
  const rows = await pupilsOf(database.db, classId)
  return rows.map(({ id, nickname, isNew, lockedAt, handAt }) => ({
    ...{ id, nickname, isNew: isNew === 1, locked: isLocked(lockedAt, now()), handAt },
    live: live.liveOf(classId, id),
  }))
}

/** The live view: the class, and a tile a pupil, those who need somebody first. */
async function stateOf(ports: Ports, row: ClassRow) {
  const now = ports.now()
  const tiles = inOrder(await tilesOf(ports, row.id), now)
  return { now, class: shownClass(row, ports), attention: ports.live.attentionOf(row.id), tiles }
}

const view = async ({ ports, who }: Call<undefined>): Promise<Answer> => ({
  body: await stateOf(ports, who.class!),
})

function stream({ ports, who }: Call<undefined>): Promise<Response> {
  const { id } = who.class!
  const read = async () => {
    const row = await classById(ports.database.db, id)
    return row && !(await isHidden(ports, row)) ? await stateOf(ports, row) : null
  }
  return Promise.resolve(ports.live.open({ class: id, pupil: null, teacher: who.teacher?.id ?? null, read }))
}

function attention({ ports, who, body }: Call<{ readonly on: boolean }>): Promise<Answer> {
  return Promise.resolve({ body: { seconds: ports.live.askAttention(who.class!.id, body.on) } })
}

async function setFree({ ports, who, body }: Call<v.InferOutput<typeof free>>): Promise<Answer> {
  const { cards, level } = body
  await changeClass(ports.database.db, who.class!.id, { cards: cards && JSON.stringify(cards), level })
  ports.live.changed(who.class!.id)
  return {}
}

/** Those of the class who are meant. @throws Refusal 404 where one is none of its pupils */
async function meant(
  ports: Ports,
  classId: string,
  to: 'all' | readonly string[],
): Promise<readonly string[]> {
  const known = (await pupilsOf(ports.database.db, classId)).map(({ id }) => id)
  if (to === 'all') return known
  if (!to.every((id) => known.includes(id))) throw new Refusal(404, 'noSuchPupil')
  return [...new Set(to)]
}

interface Handout {
  readonly kind: 'hint' | 'program'
  readonly card?: string
  readonly hint?: number
  readonly text?: string
  readonly document?: string
}

async function hand(
  ports: Ports,
  classId: string,
  to: 'all' | readonly string[],
  given: Handout,
): Promise<Answer> {
  const pupils = await meant(ports, classId, to)
  const { kind, card = null, hint = null, text = null, document = null } = given
  const row = {
    id: newToken(ports.random),
    class: classId,
    kind,
    card,
    hint,
    text,
    document,
    at: ports.now(),
  }
  if (pupils.length > 0)
    await ports.database.db.transaction().execute((inside) => addHandout(inside, row, pupils))
  ports.live.changed(classId, pupils)
  return { status: 201, body: { id: row.id, pupils: pupils.length } }
}

const handOut = ({
  ports,
  who,
  body: { to, ...given },
}: Call<v.InferOutput<typeof handout>>): Promise<Answer> => hand(ports, who.class!.id, to, given)

/** A start program as a project, checked as children's own are. */
async function handProgram({ ports, who, query, body }: Call<string>): Promise<Answer> {
  const to = query.get('to') ?? ''
  const checked = await ports.checkProject(body)
  if ('refused' in checked) throw new Refusal(422, 'projectRefused', { reason: checked.refused })
  const ids = to === 'all' ? to : to.split(',')
  const text = checked.name.slice(0, 100)
  return hand(ports, who.class!.id, ids, { kind: 'program', text, document: body })
}

/** For how long a look lasts that is not repeated, s. */
const glance = 15
const nameOf = ({ teacher }: Who) => teacher?.username ?? null

async function pupilIn({ ports, who, at }: Call<unknown>) {
  const pupil = await pupilOf(ports.database.db, who.class!.id, at['pupil']!)
  if (!pupil) throw new Refusal(404, 'noSuchPupil')
  return pupil
}

/** The child's work as the class has it, while the child sees who looks. */
async function lookInside(call: Call<undefined>): Promise<Answer> {
  const { ports, who, query } = call
  const { id, class: classId } = await pupilIn(call)
  ports.live.look(classId, id, nameOf(who), glance)
  const [newest] = await projectsOf(ports.database.db, id)
  const project = ports.live.liveOf(classId, id)?.project ?? newest?.id
  const found = project === undefined ? null : await versionOf(ports.database.db, id, project)
  const seen = found && query.get('known') === `${project}:${found.revision}`
  return {
    body: {
      seconds: glance,
      project: found && { id: project, ...found, ...(seen ? { project: null } : {}) },
    },
  }
}

async function lookAway(call: Call<undefined>): Promise<Answer> {
  const { id, class: classId } = await pupilIn(call)
  call.ports.live.look(classId, id, nameOf(call.who), 0)
  return {}
}

const watching = ['owner', 'substitute'] as const
const one = '/classes/:class'

export const liveTeacherRoutes: readonly Route[] = [
  route('GET', `${one}/live`, watching, view),
  route('GET', `${one}/stream`, watching, stream),
  route('PUT', `${one}/attention`, watching, attention, v.strictObject({ on: v.boolean() })),
  route('PUT', `${one}/free`, ['owner'], setFree, free),
  route('POST', `${one}/handouts`, watching, handOut, handout),
  route('POST', `${one}/programs`, watching, handProgram, 'project'),
  route('POST', `${one}/pupils/:pupil/inside`, watching, lookInside),
  route('DELETE', `${one}/pupils/:pupil/inside`, watching, lookAway),
]
