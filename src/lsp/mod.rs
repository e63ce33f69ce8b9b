//! The language server: what `ide` answers, in the protocol that editors speak.
//!
//! The server's thread holds the open documents and answers at once from a text and its names; another
//! one (`worker`) evaluates, and is stopped by the next edit. Findings belong to a version of the text
//! and are told only while that is the newest.

mod answers;
mod capabilities;
mod changes;
mod closer_look;
mod commands;
mod convert;
mod documents;
mod findings;
mod looks;
mod navigation;
mod paths;
mod renaming;
mod server;
mod serving;
mod telling;
mod transport;
mod viewer;
mod worker;

use std::io;

use lsp_server::{Connection, ProtocolError};

use self::transport::Outgoing;
use crate::{
    limits::{stack, work::StopToken},
    session::Session,
};

/// What makes a session that is stopped by a switch.
pub(crate) type SessionMaker<'a> = &'a (dyn Fn(StopToken) -> Session + Sync);

/// Serves a client over standard input and output until it says goodbye.
///
/// # Errors
/// Where it says something else first.
pub(crate) fn serve_streams(session: SessionMaker<'_>) -> io::Result<()> {
    let input = io::BufReader::new(io::stdin());
    let (connection, told, writer) = transport::connect(input, io::BufWriter::new(io::stdout()));
    let served = converse(connection, session, &|message| {
        // Where the client is gone the loop ends.
        let _ = told.send(message);
    });
    drop(told);
    let written = writer.join().unwrap_or_else(|_| Err(io::Error::other("the writer failed")));
    served.map_err(|err| io::Error::other(err.to_string()))?;
    written
}

/// Serves a client at the other end of a connection.
///
/// # Errors
/// Where it breaks the protocol's beginning.
pub fn serve(connection: Connection, session: SessionMaker<'_>) -> Result<(), ProtocolError> {
    let sender = connection.sender.clone();
    converse(connection, session, &|told| {
        let _ = sender.send(told.message());
    })
}

/// Greets a client over a connection, hears it there, and answers by `tell`.
fn converse(
    connection: Connection,
    session: SessionMaker<'_>,
    tell: &dyn Fn(Outgoing),
) -> Result<(), ProtocolError> {
    let greeted = connection.initialize_start().and_then(|(id, params)| {
        let client = capabilities::Client::of(&params);
        connection.initialize_finish(id, capabilities::initialize_result(&client))?;
        Ok(client)
    });
    let client = match greeted {
        // It went without a word, as it may later.
        Err(err) if err.channel_is_disconnected() => return Ok(()),
        greeted => greeted?,
    };
    let Connection { sender, receiver } = connection;
    // What was to be told by it has been.
    drop(sender);
    let queue = worker::EvaluationQueue::default();
    let (done, finished) = crossbeam_channel::unbounded();
    std::thread::scope(|scope| {
        scope.spawn(|| {
            let bytes = crate::limits::Limits::DEFAULT.stack_bytes;
            stack::with(bytes, |_| worker::work(&queue, session, &done));
        });
        let mut server = server::Server::new(&receiver, tell, &queue, session, client);
        let served = server.run(&finished);
        queue.end();
        served
    })
}
