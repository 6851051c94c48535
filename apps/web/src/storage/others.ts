import { openDB } from 'idb'
import { ownName } from './account.ts'
import { name } from './database.ts'

async function holdsProjects(database: string): Promise<boolean> {
  const db = await openDB(database)
  try {
    return db.objectStoreNames.contains('projects') && (await db.count('projects')) > 0
  } finally {
    db.close()
  }
}

/** Is work of others than who sits here on this device? It is counted, never read. Some browsers do not say. */
export async function holdsWorkOfOthers(): Promise<boolean> {
  try {
    const names = (await indexedDB.databases()).map((one) => one.name ?? '')
    const others = names.filter(
      (one) => one !== ownName(name) && (one === name || one.startsWith(`${name}-`)),
    )
    for (const one of others) if (await holdsProjects(one)) return true
    return false
  } catch {
    return false
  }
}
