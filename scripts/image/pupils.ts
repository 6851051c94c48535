import { Client, projectOfLesson } from '@botgarten/server/rehearsal'

/** A child that saves, and knows what was acknowledged. */
export interface Pupil {
  readonly client: Client
  readonly project: string
  acknowledged: number
}

/** A pupil as it was kept. */
export function pupilOf(
  url: string,
  { cookies, project, acknowledged }: Omit<Pupil, 'client'> & { readonly cookies: [string, string][] },
): Pupil {
  const client = new Client(url)
  for (const [name, value] of cookies) client.cookies.set(name, value)
  return { client, project, acknowledged }
}

const markOf = (count: number) => `save ${count}`

/** A teacher, an open class, and pupils in it. @param token of the link for the first teacher */
export async function openLesson(url: string, token: string, many: number): Promise<Pupil[]> {
  const teacher = new Client(url)
  await teacher.untilDone('POST', '/teachers', { token, username: 'm.weber', password: 'kastanie im regen' })
  const endsOn = `${new Date().getFullYear() + 1}-07-31`
  const made = { name: 'Bach', language: 'en', grade: 5, endsOn }
  const { id } = await teacher.untilDone<{ id: string }>('POST', '/classes', made)
  await teacher.untilDone('POST', `/classes/${id}/open`)
  const { words } = await teacher.untilDone<{ words: string[] }>('GET', `/classes/${id}`)
  const pupils: Pupil[] = []
  for (let at = 0; at < many; at++) {
    const client = new Client(url)
    await client.untilDone('POST', '/join', { code: words.join(' '), nickname: `Kind ${at}` })
    pupils.push({ client, project: `power-cut-${at}`, acknowledged: 0 })
  }
  return pupils
}

/** One save. @returns the status; null where nobody answered */
export async function saveOnce(pupil: Pupil): Promise<number | null> {
  const count = pupil.acknowledged
  const path = `/projects/${pupil.project}?base=${count}&save=power-cut-${count}`
  const answer = await pupil.client.ask('PUT', path, projectOfLesson(markOf(count), 1)).catch(() => null)
  if (answer && answer.status < 300) pupil.acknowledged++
  return answer?.status ?? null
}

/** Saves until nobody answers any more. @returns how many were acknowledged */
export async function saveUntilCut(pupil: Pupil): Promise<number> {
  let saves = 0
  for (;;) {
    const status = await saveOnce(pupil)
    if (status === null) return saves
    if (status < 300) saves++
  }
}

/**
 * How many acknowledged saves are not there. The one that was under way when the plug was pulled may have arrived; it is
 * then counted as acknowledged from here on.
 */
export async function lostOf(pupil: Pupil): Promise<number> {
  if (pupil.acknowledged === 0) return 0
  const found = await pupil.client.untilDone<{ revision: number; project: { name: string } }>(
    'GET',
    `/projects/${pupil.project}`,
  )
  const lost = Math.max(0, pupil.acknowledged - found.revision)
  const right = found.project.name === markOf(found.revision - 1) && found.revision <= pupil.acknowledged + 1
  pupil.acknowledged = found.revision
  return right ? lost : Math.max(1, lost)
}
