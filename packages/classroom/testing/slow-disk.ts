// Preloaded by Node (`--import`): every wait of SQLite for the disk takes SLOW_DISK milliseconds more, as on a worn card.
import SqliteFile from 'better-sqlite3'

const more = Number(process.env['SLOW_DISK'] ?? 30)
const nothing = new Int32Array(new SharedArrayBuffer(4))
/** Holds the thread up, as waiting for the disk does. */
const wait = (times: number) => void Atomics.wait(nothing, 0, 0, times * more)

// oxlint-disable-next-line typescript/unbound-method -- each is called with its own database below
const { prepare, pragma } = SqliteFile.prototype

function slowPrepare(this: SqliteFile.Database, query: string): SqliteFile.Statement {
  const statement = prepare.call(this, query)
  if (!/^commit$/i.test(query)) return statement
  const run = statement.run.bind(statement) as () => SqliteFile.RunResult
  return Object.assign(statement, { run: () => (wait(1), run()) })
}

/** Putting the journal away waits for the journal and for the file. */
function slowPragma(this: SqliteFile.Database, ...asked: Parameters<typeof pragma>): unknown {
  if (asked[0].startsWith('wal_checkpoint')) wait(2)
  return pragma.apply(this, asked)
}

Object.assign(SqliteFile.prototype, { prepare: slowPrepare, pragma: slowPragma })
