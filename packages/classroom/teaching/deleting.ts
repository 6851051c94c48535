import { refusalOfDatabase } from '../database/errors.ts'
import type { Ports, Tombstone } from '../ports.ts'
import { forgetClass } from '../questionnaires/askings-store.ts'
import { begunDeletions, carryOut } from './deleting-store.ts'
import { deleteInSteps } from './steps-store.ts'

const isFull = (error: unknown) => refusalOfDatabase(error)?.code === 'diskFull'

interface Working<Result> {
  readonly work: () => Promise<Result>
  readonly again?: () => Promise<Result>
  readonly bytes?: number
}

/** Works, and works again with room of the reserve if the disk is full. @param bytes of the reserve; all of it if left out */
async function withReserve<Result>(
  ports: Ports,
  { work, again = work, bytes }: Working<Result>,
): Promise<Result> {
  try {
    return await work()
  } catch (error) {
    if (!isFull(error)) throw error
    ports.host.useReserve(bytes)
    ports.database.emptyJournal()
    return await again()
  }
}

/** For a few rows that have to be written before something can be deleted. */
export const withRoom = <Result>(ports: Ports, work: () => Promise<Result>): Promise<Result> =>
  withReserve(ports, { work, bytes: 1_000_000 })

/** A deletion in one transaction, and where the disk has no room for that, in many. */
async function deleteRows(ports: Ports, { kind, id }: Tombstone): Promise<void> {
  const { database } = ports
  if (kind === 'class') await withReserve(ports, { work: () => forgetClass(database.answers.db, id) })
  const all = () => database.db.transaction().execute((inside) => carryOut(inside, { kind, id }))
  const inSteps = async () => {
    if (database.kind === 'sqlite') await deleteInSteps(database, { kind, id })
    await all()
  }
  await withReserve(ports, { work: all, again: inSteps })
  database.emptyJournal()
}

/** Deletes a class or a pupil with all its data, also on a full disk. The list of deletions has it first. */
export async function deleteForGood(ports: Ports, tombstone: Tombstone): Promise<void> {
  await withReserve(ports, { work: () => ports.bury(tombstone) })
  await deleteRows(ports, tombstone)
}

/** Finishes deletions in steps that were interrupted. */
export async function finishDeletions(ports: Ports): Promise<void> {
  for (const tombstone of await begunDeletions(ports.database.db)) await deleteRows(ports, tombstone)
}
