/** What the browser keeps: tokens, answers as they were given, and what the screen is like. */

const NAME = "nacreous";

/** Open the database; rejects where the browser keeps nothing, as some do in private windows. */
export function openDatabase(): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open(NAME, 1);
    request.onupgradeneeded = () => {
      request.result.createObjectStore("tokens");
      request.result.createObjectStore("screens");
      request.result.createObjectStore("answers", { keyPath: ["sitting", "trial"] });
    };
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
    request.onblocked = () => reject(new Error("the database is in use by an older page"));
  });
}

/** Write into one store; resolves when it is on the disk, as far as the browser can know. */
export function write(
  database: IDBDatabase,
  store: string,
  act: (store: IDBObjectStore) => void,
): Promise<void> {
  return new Promise((resolve, reject) => {
    const transaction = database.transaction(store, "readwrite", { durability: "strict" });
    transaction.oncomplete = () => resolve();
    transaction.onabort = () => reject(transaction.error);
    act(transaction.objectStore(store));
  });
}

/** Read from one store. */
export function read<T>(
  database: IDBDatabase,
  store: string,
  act: (store: IDBObjectStore) => IDBRequest<T>,
): Promise<T> {
  return new Promise((resolve, reject) => {
    const request = act(database.transaction(store, "readonly").objectStore(store));
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}
