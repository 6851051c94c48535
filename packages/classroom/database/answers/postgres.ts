import { Kysely, PostgresDialect } from 'kysely'
import pg from 'pg'
import { openPool } from '../postgres-pool.ts'
import type { AnswersDatabase } from './database.ts'
import type { AnswerTables } from './tables.ts'

/** Who owns the answers: queries of the lab, which are another role's, cannot read them. */
const role = 'botgarten_answers'

interface Place {
  readonly schema: string
  /** Leads into the schema, as the role. */
  readonly address: string
}

/** What is there already, or is not allowed here, is seen by what comes next. */
const tried = (client: pg.Client, query: string) => client.query(query).catch(() => null)

/** A connection of its own. If it breaks between two queries, the next query rejects. */
async function connect(address: string): Promise<pg.Client> {
  const client = new pg.Client({ connectionString: address })
  client.on('error', () => {})
  await client.connect()
  return client
}

/** Makes the role where it is missing. @returns whether this user may act as it: before PostgreSQL 16 nobody is asked so */
async function takeRole(client: pg.Client): Promise<boolean> {
  await tried(client, `create role ${role} nologin`)
  await tried(client, `grant ${role} to current_user with inherit false, set true`)
  const found = await tried(client, `select pg_has_role(current_user, '${role}', 'SET') as may`)
  return (found?.rows[0] as { may: boolean } | undefined)?.may ?? false
}

async function ownerOf(client: pg.Client, schema: string): Promise<string | null> {
  const query = 'select pg_get_userbyid(nspowner) as owner from pg_namespace where nspname = $1'
  const { rows } = await client.query<{ owner: string }>(query, [schema])
  return rows[0]?.owner ?? null
}

/** Makes the schema where it is missing. @returns who owns it */
async function ownedSchema(client: pg.Client, schema: string): Promise<string | null> {
  const found = await ownerOf(client, schema)
  if (found !== null) return found
  const owner = (await takeRole(client)) ? ` authorization ${role}` : ''
  await client.query(`create schema if not exists ${client.escapeIdentifier(schema)}${owner}`)
  return ownerOf(client, schema)
}

/** Where answers lie beside the tables of an address. @throws the database's error */
async function placeOn(address: string): Promise<Place> {
  const client = await connect(address)
  try {
    const { rows } = await client.query<{ schema: string | null }>('select current_schema() as schema')
    const beside = rows[0]?.schema ?? 'public'
    const schema = beside === 'public' ? 'answers' : `${beside}_answers`
    const owner = await ownedSchema(client, schema)
    const url = new URL(address)
    const acting = owner === role ? `-c role=${role} ` : ''
    url.searchParams.set('options', `${acting}-c search_path=${schema}`)
    return { schema, address: url.href }
  } finally {
    await client.end()
  }
}

/** A schema and a role of their own, made when they are first asked for. @param address of the lab's database */
export function openAnswersOn(address: string): AnswersDatabase {
  let found: Promise<Place> | null = null
  const place = () => {
    found ??= placeOn(address).catch((error: unknown) => {
      found = null
      throw error
    })
    return found
  }
  const pool = async () => openPool((await place()).address, 4)
  const db = new Kysely<AnswerTables>({ dialect: new PostgresDialect({ pool }) })
  return {
    ...{ db, locks: true, copy: null },
    schema: async () => (await place()).schema,
    vacuum: async () => vacuum((await place()).address),
    close: () => db.destroy(),
  }
}

/** Rewrites the tables. It has no time limit, since it takes longer the more answers there are. */
async function vacuum(address: string): Promise<void> {
  const client = await connect(address)
  try {
    await client.query('vacuum (full) asking, answer, code, published')
  } finally {
    await client.end()
  }
}

/** Removes the answers beside the tables of an address, with their schema. */
export async function dropAnswers(address: string): Promise<void> {
  const { schema, address: own } = await placeOn(address)
  const client = await connect(own)
  try {
    await client.query(`drop schema ${client.escapeIdentifier(schema)} cascade`)
  } finally {
    await client.end()
  }
}
