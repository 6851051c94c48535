import type SqliteFile from 'better-sqlite3'
import { SqliteDialect, type Driver } from 'kysely'

/** How long a statement waits while another process holds the file, ms. It stops everything else in this process. */
export const busyTimeout = 1000

/** SQLite rolls back by itself when the disk is full: rolling back again would hide that error behind another one. */
export class Dialect extends SqliteDialect {
  private readonly file: SqliteFile.Database

  constructor(file: SqliteFile.Database) {
    super({ database: file })
    this.file = file
  }

  override createDriver(): Driver {
    const driver = super.createDriver()
    const rollback = driver.rollbackTransaction.bind(driver)
    driver.rollbackTransaction = (connection) =>
      this.file.inTransaction ? rollback(connection) : Promise.resolve()
    return driver
  }
}
