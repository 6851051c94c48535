import { account } from '#storage/account.ts'
import { holdsWorkOfOthers } from '#storage/others.ts'
import { list } from '#storage/projects.ts'

/** What this browser keeps under the address of the page. */
export interface Kept {
  /** Works of who sits here. */
  readonly own: number
  /** Work of others is here, too. */
  readonly others: boolean
}

export async function keptHere(): Promise<Kept> {
  const { projects, damaged } = await list()
  return { own: projects.length + damaged.length, others: await holdsWorkOfOthers() }
}

/** Where who sits here goes on: a pupil joins there again, all others begin where they meant to. */
export function wayTo(announced: string, at: Pick<Location, 'pathname' | 'hash'>): string {
  const joins = account() !== null || at.pathname === '/join'
  return joins ? `${announced}/join${at.pathname === '/join' ? at.hash : ''}` : `${announced}/`
}
