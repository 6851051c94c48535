import { readPupil, type Pupil } from './joining/sessions-store.ts'
import type { Ports } from './ports.ts'
import { Refusal } from './refusal.ts'
import { cookieIn, pupilCookie, substituteCookie } from './joining/cookies.ts'
import { isOperator } from './teaching/operators-store.ts'
import { classLent } from './teaching/substitutes-store.ts'
import { classOf } from './teaching/classes-store.ts'
import { refuseHidden } from './teaching/ending-store.ts'
import type { Teacher } from './teaching/accounts.ts'
import type { ClassRow } from './database/tables.ts'

/**
 * Who may ask a route:
 * - `anyone`: also nobody
 * - `pupil`: joined, or showed the pictures, within this lesson
 * - `returning`: a pupil whose lesson is over, who has to show the pictures before anything is read
 * - `teacher`: signed in, for what names no class
 * - `owner`: the teacher of the class that the route names
 * - `substitute`: somebody with a link to the class that the route names, until midnight
 * - `operator`: invites teachers and sees sizes, never what is in a class
 */
export type Role = 'anyone' | 'pupil' | 'returning' | 'teacher' | 'owner' | 'substitute' | 'operator'

export interface Who {
  readonly pupil: Pupil | null
  readonly teacher: Teacher | null
  /** The class that the route names, and that the teacher owns or the substitute has today. */
  readonly class: ClassRow | null
}

const nobody: Who = { pupil: null, teacher: null, class: null }

/**
 * Finds out whether the sender of a request has one of the roles.
 * @throws Refusal 401 for nobody, 403 for a role that is not enough, 404 for the class of somebody else, 410 for a class that was
 * deleted, 423 for one that has ended and is not deleted yet
 */
export async function whoAsks(
  ports: Ports,
  roles: readonly Role[],
  headers: Headers,
  classId: string | undefined,
): Promise<Who> {
  if (roles.includes('anyone')) return nobody
  if (roles.includes('pupil') || roles.includes('returning')) return pupilAsking(ports, roles, headers)
  if (roles.includes('owner')) return classAsking(ports, roles, headers, classId ?? '')
  const teacher = await ports.accounts.teacherOf(headers)
  if (!teacher) throw new Refusal(401, 'signIn')
  if (roles.includes('teacher')) return { ...nobody, teacher }
  if (!(await isOperator(ports.database.db, teacher.id))) throw new Refusal(403, 'notYours')
  return { ...nobody, teacher }
}

async function classAsking(
  ports: Ports,
  roles: readonly Role[],
  headers: Headers,
  classId: string,
): Promise<Who> {
  const { db } = ports.database
  const teacher = await ports.accounts.teacherOf(headers)
  const own = teacher && (await classOf(db, classId, teacher.id))
  if (own) return await shown(ports, { ...nobody, teacher, class: own })
  const token = roles.includes('substitute') ? cookieIn(headers, substituteCookie) : null
  const lent = token === null ? undefined : await classLent(db, token, ports.day(0))
  if (lent?.id === classId) return await shown(ports, { ...nobody, class: lent })
  // Whether another teacher has such a class is not revealed.
  throw teacher || lent ? new Refusal(404, 'noSuchClass') : new Refusal(401, 'signIn')
}

async function shown(ports: Ports, who: Who & { readonly class: ClassRow }): Promise<Who> {
  await refuseHidden(ports, who.class)
  return who
}

async function pupilAsking(ports: Ports, roles: readonly Role[], headers: Headers): Promise<Who> {
  const pupil = await readPupil(ports, cookieIn(headers, pupilCookie))
  if (!pupil) throw new Refusal(401, 'join')
  refuseOther(headers, pupil)
  if (!roles.includes(pupil.fresh ? 'pupil' : 'returning')) throw new Refusal(401, 'showPictures')
  return { ...nobody, pupil }
}

/** A page sends whose it is: left open while another child has signed in, it neither sends nor gets anything of theirs. */
function refuseOther(headers: Headers, { id }: Pupil): void {
  const meant = headers.get('botgarten-pupil')
  if (meant !== null && meant !== id) throw new Refusal(403, 'otherPupil')
}
