import { dropAnswers } from '@botgarten/classroom'
import pg from 'pg'

/** Makes a schema of its own in a database. @returns an address that leads into it, and how to remove it */
export async function ownSchema(address: string, name: string) {
  const run = async (query: string) => {
    const client = new pg.Client({ connectionString: address })
    await client.connect()
    try {
      await client.query(query)
    } finally {
      await client.end()
    }
  }
  await run(`create schema ${name}`)
  const url = new URL(address)
  url.searchParams.set('options', `-c search_path=${name}`)
  const remove = async () => {
    // Its answers lie beside it, and are another role's.
    await dropAnswers(url.href)
    await run(`drop schema ${name} cascade`)
  }
  return { address: url.href, remove }
}
